#include "app/widgets/job_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace app {

JobDialog::JobDialog(const QString& name, const QString& start, QWidget* parent)
    : QDialog(parent), m_foot(new JobBar(name, start, this)) {
    connect(m_foot, &JobBar::startAsked, this, [this] {
        if (!m_job) this->start();
    });
    connect(m_foot, &JobBar::cancelAsked, this, &JobDialog::reject);
    connect(m_foot, &JobBar::closeAsked, this, &JobDialog::reject);
}

void JobDialog::reject() { m_job ? m_cancel() : QDialog::reject(); }

QHBoxLayout* JobDialog::makeTarget(const QString& objectName, const QString& name, const QString& usual) {
    m_target = new QLineEdit(usual, this);
    m_target->setObjectName(objectName);
    m_target->setAccessibleName(name);
    connect(m_target, &QLineEdit::textChanged, this, [this] { showOrder(); });
    auto* choose = new QPushButton(tr("Choose"), this);
    connect(choose, &QPushButton::clicked, this, [this] {
        if (const QString chosen = chooseTarget(); !chosen.isEmpty()) m_target->setText(chosen);
    });
    auto* row = new QHBoxLayout;
    row->addWidget(m_target, 1);
    row->addWidget(choose);
    return row;
}

// Where the program was started says nothing to who typed the name.
std::filesystem::path JobDialog::target() const {
    QString typed = m_target->text();
    if (typed == "~" || typed.startsWith("~/")) typed.replace(0, 1, QDir::homePath());
    return QDir::home().absoluteFilePath(typed).toStdString();
}

void JobDialog::finish(const QString& sentence, const std::filesystem::path& written) {
    m_job->deleteLater();
    m_job = nullptr;
    const QFileInfo file(toQString(written.string()));
    m_foot->finish(sentence, written.empty() ? QString() : file.isDir() ? file.filePath() : file.path());
}

}  // namespace app
