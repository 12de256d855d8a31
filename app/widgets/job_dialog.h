#pragma once
#include <QDialog>
#include <filesystem>
#include <functional>

#include "app/look/text.h"
#include "app/widgets/job_bar.h"
#include "app/widgets/tab_order.h"
#include "pipeline/core/result.h"

class QHBoxLayout;
class QLineEdit;

namespace app {

// A dialog that writes files on another thread: a field for the place, and a bottom line. While it writes, Esc and the
// title bar's cross cancel the job and the dialog reports that; otherwise they close it.
class JobDialog : public QDialog {
    Q_OBJECT
public:
    QString message() const { return m_foot->message(); }
    void reject() override;

protected:
    // name, start: of the foot.
    JobDialog(const QString& name, const QString& start, QWidget* parent);

    // The field, and the button that asks for another place. The name is also that for a screen reader.
    QHBoxLayout* makeTarget(const QString& objectName, const QString& name, const QString& usual);
    virtual QString chooseTarget() = 0;  // empty: none was chosen
    virtual void showOrder() = 0;        // what would be written has changed
    virtual void start() = 0;

    QLineEdit& field() const { return *m_target; }
    // As typed, from the home folder on; "~" is that too.
    std::filesystem::path target() const;
    JobBar& foot() const { return *m_foot; }
    bool isRunning() const { return m_job != nullptr; }

    // words(summary): what has been written, as a sentence.
    template <class Job, class Words>
    void run(Job* job, const std::filesystem::path& to, Words words) {
        connect(job, &Job::progressed, m_foot,
                [this](double share, const QString& file = {}) { m_foot->setProgress(share, file); });
        connect(job, &Job::finished, this, [this, to, words](const auto& summary) {
            finish(summary.cancelled ? tr("Cancelled. Nothing was written.") : words(summary),
                   summary.cancelled ? std::filesystem::path() : to);
        });
        connect(job, &Job::failed, this,
                [this](const pipeline::Errors& errors) { finish(toQString(format(errors)).trimmed(), {}); });
        m_job = job;
        m_cancel = [job] { job->cancel(); };
        m_foot->begin();
    }

    bool focusNextPrevChild(bool next) override { return focusNext(*this, next) || QDialog::focusNextPrevChild(next); }

private:
    void finish(const QString& sentence, const std::filesystem::path& written);

    JobBar* m_foot;
    QLineEdit* m_target = nullptr;
    QObject* m_job = nullptr;  // one writes at a time
    std::function<void()> m_cancel;
};

}  // namespace app
