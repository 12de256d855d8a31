#pragma once
#include <QImage>
#include <QObject>
#include <QString>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "pipeline/study/run_study.h"

namespace app {

// The pictures of one setting of a study: a null image where there is none.
struct SettingPictures {
    QImage image, reference, error;
    QString referenceName;  // "the true surfaces by rays"; where there is no reference, why
    double range = 0;       // the error's palette goes from −range to range, in shares of I_max
};

// Computes the pictures of a setting on a thread of its own, the newest asked for. A reference stays
// for the next setting that has the same one.
class StudyImages : public QObject {
    Q_OBJECT
public:
    explicit StudyImages(QObject* parent = nullptr);
    ~StudyImages() override;  // stops what runs, and waits

    void ask(std::shared_ptr<const pipeline::Scene> scene, const std::vector<pipeline::SweepAxis>& axes,
             const pipeline::StudyPoint& point);
    void forget();  // nothing is wanted any more

signals:
    void ready(const SettingPictures& pictures);

private:
    struct Job {
        std::shared_ptr<const pipeline::Scene> scene;
        std::vector<pipeline::SweepAxis> axes;
        pipeline::StudyPoint point;
        long ticket = 0;
    };
    void work(const std::stop_token& quit);

    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    // Guarded by m_mutex.
    std::optional<Job> m_next;
    std::stop_source m_stop;

    long m_ticket = 0;      // of the newest request; the GUI thread alone
    std::jthread m_thread;  // last: starts when all else is there
};

}  // namespace app
