#include "app/panels/study_run.h"

#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>
#include <thread>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"

namespace app {

StudyRun::StudyRun(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_sweep(pipeline::Error{{}, "no sweep is chosen"}) {
    const auto number = [this](const QString& name, int low, int high, int value, const QString& tip) {
        auto* box = new QSpinBox(this);
        box->setObjectName(name);
        box->setRange(low, high);
        box->setValue(value);
        box->setToolTip(tip);
        return box;
    };
    m_repeats = number("studyRepeats", 1, 1000, 21, tr("The time of a point is the median of so many frames."));
    m_threads = number("studyThreads", 1, std::max(1, int(std::thread::hardware_concurrency())), 1,
                       tr("How many threads compute a frame."));
    auto* form = new QFormLayout;
    form->addRow(tr("Frames per point"), m_repeats);
    form->addRow(tr("Threads"), m_threads);
    m_begin = new QPushButton(tr("Measure"), this);
    m_begin->setObjectName("studyBegin");
    m_begin->setProperty("kind", "primary");
    m_cancel = new QPushButton(tr("Cancel"), this);
    m_cancel->setObjectName("studyCancel");
    m_bar = new QProgressBar(this);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(tr("Progress of the study"));
    m_words = new QLabel(this);
    m_words->setObjectName("studyProgress");
    m_words->setWordWrap(true);
    m_words->setProperty("tone", 2);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_begin);
    buttons->addWidget(m_cancel);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addLayout(buttons);
    column->addWidget(m_bar);
    column->addWidget(m_words);
    connect(m_begin, &QPushButton::clicked, this, &StudyRun::begin);
    connect(m_cancel, &QPushButton::clicked, this, &StudyRun::cancel);
    // Points of a scene that is closed say nothing about the next one.
    connect(&document, &Document::sceneOpened, this, [this] {
        m_leftScene = m_job != nullptr;
        cancel();
    });
    followTheme(this, [this, column] {
        const Theme& theme = Theme::current();
        m_words->setFont(theme.text(12));
        m_bar->setFixedHeight(theme.px(6));
        column->setSpacing(theme.px(6));
    });
    showState();
}

void StudyRun::setSweep(pipeline::Result<pipeline::Sweep> sweep) {
    m_sweep = std::move(sweep);
    showState();
}

void StudyRun::begin() {
    m_leftScene = false;
    if (m_job || !m_sweep || !m_document.hasScene()) return;
    pipeline::StudyRequest request;
    request.scene = std::make_shared<const pipeline::Scene>(m_document.scene());
    request.sweep = *m_sweep;
    request.threads = m_threads->value();
    request.repeats = m_repeats->value();
    m_bar->setValue(0);
    m_words->setText(tr("begins"));
    m_job = std::make_unique<StudyJob>(std::move(request));
    connect(m_job.get(), &StudyJob::progressed, this, [this](double share, const QString& what, double secondsLeft) {
        m_bar->setValue(int(share * m_bar->maximum()));
        const QString left = secondsLeft >= 1 ? tr(", about %1 s left").arg(std::ceil(secondsLeft)) : QString();
        if (m_cancel->isEnabled()) m_words->setText(what + left);
    });
    connect(m_job.get(), &StudyJob::reported, this, [this](const pipeline::StudyReport& report) {
        m_anything = true;
        emit reported(report);
    });
    connect(m_job.get(), &StudyJob::finished, this, [this](bool cancelled) {
        finish(!cancelled ? tr("All points are measured.")
               : std::exchange(m_leftScene, false) && !m_anything
                   ? tr("Another scene was opened. Nothing was measured.")
               : m_anything ? tr("Cancelled. The first look at the times is kept.")
                            : tr("Cancelled. Nothing was measured."));
    });
    m_anything = false;
    showState();
}

void StudyRun::cancel() {
    if (!m_job) return;
    m_job->cancel();
    m_words->setText(tr("stops"));
    m_cancel->setEnabled(false);
}

void StudyRun::finish(const QString& words) {
    // Its own signal is being handled.
    m_job.release()->deleteLater();
    m_words->setText(words);
    showState();
}

void StudyRun::showState() {
    const bool running = m_job != nullptr;
    m_begin->setEnabled(!running && m_sweep);
    m_begin->setToolTip(m_sweep ? running ? tr("A study is being measured.") : tr("Measures every point of the sweep.")
                                : toQString(format(m_sweep.errors().front())));
    m_cancel->setEnabled(running);
    m_cancel->setToolTip(running ? tr("Stops it. A first look at the times is kept, where it has come so far.")
                                 : tr("Nothing is being measured."));
    m_repeats->setEnabled(!running);
    m_threads->setEnabled(!running);
    m_bar->setVisible(running);
}

}  // namespace app
