#pragma once
#include <QImage>
#include <QObject>
#include <QString>
#include <optional>

#include "app/jobs/background_job.h"
#include "pipeline/study/run_study.h"

namespace app {

// The pictures of one setting of a study; a null image if there is none.
struct SettingPictures {
    QImage image, reference, error;
    QString referenceName;  // "the true surfaces by rays"; without a reference, the reason
    double range = 0;       // the error's palette goes from −range to range, in fractions of I_max
};

// Computes the pictures of a setting on a thread of its own, always for the newest request. The reference is kept for
// the next setting with the same one.
class StudyImages : public QObject {
    Q_OBJECT
public:
    explicit StudyImages(QObject* parent = nullptr);

    void ask(std::shared_ptr<const pipeline::Scene> scene, const std::vector<pipeline::SweepAxis>& axes,
             const pipeline::StudyPoint& point);
    void forget();  // nothing is wanted any more

signals:
    void ready(const SettingPictures& pictures);

private:
    // Used by the job's thread only: computes the settings of one study, and which study that is.
    std::optional<pipeline::ErrorFinder> m_finder;
    std::shared_ptr<const pipeline::Scene> m_scene;
    std::vector<pipeline::SweepAxis> m_axes;
    BackgroundJob m_job;  // last: it ends before the members that its work uses
};

}  // namespace app
