#include "app/widgets/job_bar.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>

#include "app/widgets/follow_theme.h"

namespace app {

JobBar::JobBar(const QString& name, const QString& start, QWidget* parent)
    : QWidget(parent),
      m_command(new QLineEdit(this)),
      m_message(styled(new QLabel(this), {.wraps = true})),
      m_progress(new QProgressBar(this)),
      m_showFolder(new QPushButton(tr("Show folder"), this)),
      m_cancel(new QPushButton(tr("Cancel"), this)),
      m_start(new QPushButton(start, this)) {
    auto* same = new QLabel(tr("The same as"), this);
    same->setProperty("tone", 2);
    m_command->setObjectName(name + "Command");
    m_command->setAccessibleName(tr("The same as a command"));
    m_command->setReadOnly(true);
    m_message->setObjectName(name + "Message");
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_cancel->setObjectName(name + "Cancel");
    m_start->setObjectName(name + "Start");
    m_start->setProperty("kind", "primary");
    m_start->setDefault(true);
    connect(m_start, &QPushButton::clicked, this, &JobBar::startAsked);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_running ? emit cancelAsked() : emit closeAsked(); });
    connect(m_showFolder, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(m_folder)); });

    auto* command = new QHBoxLayout;
    command->addWidget(same);
    command->addWidget(m_command, 1);
    m_row = new QHBoxLayout;
    m_row->addWidget(m_message, 1);
    m_row->addWidget(m_showFolder);
    m_row->addWidget(m_cancel);
    m_row->addWidget(m_start);
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addLayout(command);
    column->addWidget(m_progress);
    column->addLayout(m_row);
    m_progress->hide();
    m_showFolder->hide();
    followTheme(this, [this] {
        m_command->setFont(Theme::current().mono(12));
        m_progress->setFixedHeight(Theme::current().px(6));
    });
}

QPushButton* JobBar::addButton(const QString& objectName, const QString& text) {
    m_other = new QPushButton(text, this);
    m_other->setObjectName(objectName);
    m_other->setAutoDefault(false);
    m_row->insertWidget(m_row->indexOf(m_cancel), m_other);
    showButtons();
    return m_other;
}

void JobBar::setCommand(const QString& command) {
    m_command->setText(command);
    m_command->setCursorPosition(0);
}

QString JobBar::message() const { return m_message->text(); }

void JobBar::setReady(bool ready, const QString& whyNot) {
    m_ready = ready;
    m_whyNot = whyNot;
    showButtons();
}

void JobBar::begin() {
    m_running = true;
    m_message->clear();
    m_progress->setValue(0);
    m_progress->show();
    m_cancel->setText(tr("Cancel"));
    showButtons();
}

void JobBar::setProgress(double share, const QString& what) {
    m_progress->setValue(int(share * 1000));
    m_message->setText(what);
}

void JobBar::finish(const QString& sentence, const QString& folder) {
    m_running = false;
    m_folder = folder;
    m_message->setText(sentence);
    m_progress->hide();
    m_showFolder->setVisible(!folder.isEmpty());
    m_cancel->setText(tr("Close"));
    showButtons();
}

void JobBar::showButtons() {
    for (QPushButton* button : {m_start, m_other}) {
        if (!button) continue;
        button->setEnabled(m_ready && !m_running);
        button->setToolTip(m_running ? tr("It is being written.") : m_ready ? QString() : m_whyNot);
    }
}

}  // namespace app
