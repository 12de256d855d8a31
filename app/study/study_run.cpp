#include "app/study/study_run.h"

#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <cmath>
#include <thread>

#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/core/text.h"

namespace app {

StudyRun::StudyRun(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_sweep(pipeline::Error{{}, "no sweep is chosen"}) {
    m_how = new QWidget(this);
    m_how->hide();
    const auto number = [this](const QString& name, int low, int high, int value, const QString& tip) {
        auto* box = new QSpinBox(m_how);
        box->setObjectName(name);
        box->setRange(low, high);
        box->setValue(value);
        box->setToolTip(tip);
        connect(box, &QSpinBox::valueChanged, this, &StudyRun::showState);
        return box;
    };
    auto* form = new QFormLayout(m_how);
    form->setContentsMargins(0, 0, 0, 0);
    m_repeats = number("studyRepeats", 1, 1000, 21, tr("The time of a point is the median of so many frames."));
    m_threads = number("studyThreads", 1, std::max(1, int(std::thread::hardware_concurrency())), 1,
                       tr("How many threads compute a frame."));
    form->addRow(tr("Frames per point"), m_repeats);
    form->addRow(tr("Threads"), m_threads);
    m_summary = new ElidedLabel(this);
    m_summary->setObjectName("studySummary");
    m_bar = new QProgressBar(this);
    m_bar->setObjectName("studyBar");
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(tr("Progress of the study"));
    m_left = new QLabel(this);
    m_left->setObjectName("studyProgress");
    for (QLabel* label : {m_summary, m_left}) label->setProperty("tone", 2), label->setTextFormat(Qt::PlainText);
    auto* setUp = new QPushButton(tr("Set up…"), this);
    setUp->setObjectName("studySetUp");
    setUp->setToolTip(tr("Choose own settings, frames per point and threads, or open a study."));
    m_one = new QStackedWidget(this);
    m_one->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_begin = new QPushButton(tr("Measure"), m_one);
    m_begin->setObjectName("studyBegin");
    m_begin->setProperty("kind", "primary");
    m_cancel = new QPushButton(tr("Cancel"), m_one);
    m_cancel->setObjectName("studyCancel");
    m_one->addWidget(m_begin);
    m_one->addWidget(m_cancel);
    auto* row = spaced(new QHBoxLayout(this), {}, 8);
    row->addWidget(m_summary, 1);
    row->addWidget(m_bar, 1);
    row->addWidget(m_left);
    row->addWidget(setUp);
    row->addWidget(m_one);
    setFocusProxy(m_one);
    connect(setUp, &QPushButton::clicked, this, &StudyRun::setUpAsked);
    connect(m_begin, &QPushButton::clicked, this, &StudyRun::begin);
    connect(m_cancel, &QPushButton::clicked, this, &StudyRun::cancel);
    // Points of a scene that is closed say nothing about the next one.
    connect(&document, &Document::sceneOpened, this, [this] {
        m_leftScene = m_job != nullptr;
        cancel();
    });
    followTheme(this, [this] { m_bar->setFixedHeight(Theme::current().px(8)); });
    showState();
}

void StudyRun::setSweep(pipeline::Result<pipeline::Sweep> sweep) {
    m_sweep = std::move(sweep);
    m_end.clear();
    showState();
}

void StudyRun::setAgain(bool again) {
    m_begin->setText(again ? tr("Measure again") : tr("Measure"));
    m_one->updateGeometry();
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
    m_left->setText(tr("begins"));
    m_end.clear();
    m_job = std::make_unique<StudyJob>(std::move(request));
    connect(m_job.get(), &StudyJob::progressed, this, [this](double share, const QString& what, double secondsLeft) {
        m_bar->setValue(int(share * m_bar->maximum()));
        if (!m_cancel->isEnabled()) return;
        const QString left = secondsLeft >= 1 ? tr(", about %1 s left").arg(std::ceil(secondsLeft)) : QString();
        m_left->setText(tr("%1 %").arg(int(100 * share)) + left);
        emit told(what);
    });
    connect(m_job.get(), &StudyJob::reported, this, [this](const pipeline::StudyReport& report) {
        m_anything = true;
        emit reported(report);
    });
    connect(m_job.get(), &StudyJob::finished, this, [this](bool cancelled) {
        finish(!cancelled ? QString()
               : std::exchange(m_leftScene, false) && !m_anything
                   ? tr("Another scene was opened. Nothing was measured.")
               : m_anything ? tr("Cancelled. The first look at the times is kept.")
                            : tr("Cancelled. Nothing was measured."));
    });
    m_anything = false;
    showState();
    emit begun();
}

void StudyRun::cancel() {
    if (!m_job) return;
    m_job->cancel();
    m_left->setText(tr("stops"));
    m_cancel->setEnabled(false);
}

void StudyRun::finish(const QString& words) {
    // Its own signal is being handled.
    m_job.release()->deleteLater();
    m_end = words;
    showState();
    emit told({});
}

// What is chosen, or why nothing can be measured.
QString StudyRun::summary() const {
    if (!m_end.isEmpty()) return m_end;
    if (!m_sweep) return toQString(format(m_sweep.errors().front()));
    const auto count = [](std::size_t number, const char* thing) {
        return toQString(pipeline::plural(std::int64_t(number), thing));
    };
    return tr("%1 · %2 each · %3")
        .arg(count(pointCount(m_sweep->axes), "point"), count(std::size_t(m_repeats->value()), "frame"),
             count(std::size_t(m_threads->value()), "thread"));
}

void StudyRun::showState() {
    const bool running = m_job != nullptr;
    const bool hadFocus =
        window()->focusWidget() == m_one->currentWidget();  // a button that is switched off gives it away
    m_begin->setEnabled(!running && m_sweep);
    m_begin->setToolTip(m_sweep ? running ? tr("A study is being measured.") : tr("Measures every point of the sweep.")
                                : toQString(format(m_sweep.errors().front())));
    m_cancel->setEnabled(running);
    m_cancel->setToolTip(running ? tr("Stops it. A first look at the times is kept, where it has come so far.")
                                 : tr("Nothing is being measured."));
    m_how->setEnabled(!running);
    for (QWidget* part : {static_cast<QWidget*>(m_bar), static_cast<QWidget*>(m_left)}) part->setVisible(running);
    m_summary->setVisible(!running);
    m_summary->setText(summary());
    QPushButton* now = running ? m_cancel : m_begin;
    m_one->setCurrentWidget(now);
    m_one->setFocusProxy(now);
    if (hadFocus) now->setFocus();
}

}  // namespace app
