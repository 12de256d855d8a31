#include "app/frames/stage_status.h"

#include <algorithm>

#include <QRegularExpression>

#include "app/look/numbers.h"
#include "app/look/text.h"
#include "pipeline/scene/settings_table.h"

namespace app {
namespace {

using pipeline::Action;
using pipeline::PlanPart;
using pipeline::PlanStep;

StageState stateOf(Action action) {
    switch (action) {
        case Action::Run: return StageState::Ran;
        case Action::Reuse: return StageState::Reused;
        case Action::LeaveOut: break;
    }
    return StageState::LeftOut;
}

// "1.5e-05 px" as "1.5e-5 px".
QString withShortExponent(QString text) {
    static const QRegularExpression zeros("e([+-])0+(?=\\d)");
    return text.replace(zeros, "e\\1");
}

QString countsText(const std::string& counts, const std::vector<PlanPart>& parts) {
    QString line = withGroups(toQString(counts));
    QStringList absent;
    for (const PlanPart& part : parts)
        if (part.action == Action::LeaveOut && part.rule && !line.contains(toQString(part.name)))
            absent += toQString(part.name);
    if (absent.isEmpty()) return line;
    if (!line.isEmpty()) line += QStringLiteral("; ");
    return line + (absent.size() == 1 ? QStringLiteral("%1 left out").arg(absent.front())
                                      : QStringLiteral("%1 parts left out").arg(absent.size()));
}

QString headLine(const pipeline::StageInfo& stage, StageState state) {
    return QStringLiteral("%1, %2").arg(toQString(stage.label), word(state));
}

// A line each: the stage and its state, what it does, why it runs or not, and its parts.
QString tooltipText(const pipeline::StageInfo& stage, const PlanStep& step, const pipeline::StageRun& run,
                    const StageStatus& status) {
    QStringList lines{headLine(stage, status.state), toQString(stage.summary)};
    if (!step.why.empty()) lines += toQString(step.why);
    if (!run.counts.empty()) lines += withGroups(toQString(run.counts));
    for (const PlanPart& part : step.parts) {
        QString line =
            QStringLiteral("· %1: %2. %3").arg(toQString(part.name), word(stateOf(part.action)), toQString(part.why));
        if (!part.saves.empty()) line += QStringLiteral(" Saves %1.").arg(toQString(part.saves));
        lines += line;
    }
    for (const pipeline::Tally& tally : run.tallies)
        if (tally.done + tally.leftOut > 0)
            lines += QStringLiteral("%1 %2, %3 left out")
                         .arg(count(tally.done), toQString(tally.what), count(tally.leftOut));
    return lines.join('\n');
}

int countOf(const pipeline::Frame& frame, Action action) {
    return int(std::ranges::count(frame.plan(), action, &PlanStep::action));
}

}  // namespace

QString errorOf(const pipeline::StageError& error) { return withShortExponent(toQString(error.text)); }

QString word(StageState state) {
    switch (state) {
        case StageState::Ran: return QStringLiteral("ran");
        case StageState::Reused: return QStringLiteral("reused");
        case StageState::LeftOut: return QStringLiteral("left out");
        case StageState::InProgress: return QStringLiteral("in progress");
        case StageState::NotYet: break;
    }
    return QStringLiteral("not yet");
}

std::array<StageStatus, pipeline::kStageCount> stageStatus(const pipeline::Frame* frame, const StageErrors& errors,
                                                           bool busy) {
    std::array<StageStatus, pipeline::kStageCount> all;
    for (const pipeline::StageId id : pipeline::kStages) {
        StageStatus& status = all[index(id)];
        const pipeline::StageInfo& stage = stageInfo(id);
        if (!frame) {
            status.state = busy ? StageState::InProgress : StageState::NotYet;
            status.tooltip = headLine(stage, status.state) + '\n' + toQString(stage.summary);
            continue;
        }
        const PlanStep& step = frame->plan()[index(id)];
        status.state = stateOf(step.action);
        status.reason = toQString(step.why);
        status.tooltip = tooltipText(stage, step, frame->run(id), status);
        if (step.action == Action::LeaveOut) continue;
        status.time = milliseconds(frame->run(id).milliseconds);
        status.error = errors[index(id)] ? errorOf(*errors[index(id)]) : QStringLiteral("…");
        status.counts = countsText(frame->run(id).counts, step.parts);
    }
    return all;
}

std::array<StageStatus, pipeline::kStageCount> stageStatus(const pipeline::Steps& steps, pipeline::Moment at,
                                                           pipeline::StepLevel level, const StageErrors& errors) {
    auto all = stageStatus(steps.frame().get(), errors, false);
    const QString current = toQString(stageInfo(at.stage).label);
    for (const pipeline::StageId id : pipeline::kStages) {
        StageStatus& status = all[index(id)];
        if (status.state == StageState::LeftOut || id < at.stage) continue;
        const bool over = id == at.stage && at.done == steps.total(id);
        if (over) continue;
        status.error.clear();
        const QString summary = toQString(stageInfo(id).summary);
        if (id > at.stage) {
            status.state = StageState::NotYet;
            status.time = QStringLiteral("–");
            status.reason = status.counts = QStringLiteral("after %1").arg(current);
        } else {
            const pipeline::Steps::Progress made = steps.progress(at);
            status.state = StageState::InProgress;
            status.time = QStringLiteral("%1 of %2 %3").arg(count(made.done), count(made.of), toQString(made.unit));
            status.reason = status.counts = toQString(steps.words(at, level));
            status.progress = double(at.done) / double(steps.total(id));
        }
        status.tooltip = QStringList{headLine(stageInfo(id), status.state), summary, status.reason}.join('\n');
    }
    return all;
}

namespace {

QString formatOf(const pipeline::Scene& scene) {
    const auto ref = pipeline::findSetting(scene, "precision");
    const QString precision = QString::fromStdString(formatSetting(*ref, ref->get(scene)));
    return QStringLiteral("%1, %2 × %3").arg(precision).arg(scene.settings.width).arg(scene.settings.height);
}

}  // namespace

static QString defectOf(const pipeline::Scene& scene) {
    const pipeline::Defect defect = scene.settings.defect;
    return defect == pipeline::Defect::None ? QString() : QStringLiteral("Planted: %1").arg(toQString(idOf(defect)));
}

FrameStatus frameStatus(const pipeline::Steps& steps, pipeline::Moment at, pipeline::StepLevel level) {
    const QString label = toQString(stageInfo(at.stage).label);
    QString words = toQString(steps.words(at, level));
    if (words.startsWith(label + ", ")) words = words.mid(label.size() + 2);  // which stands above
    const auto comma = words.indexOf(QStringLiteral(", row"));
    const QString made =
        QStringLiteral("%1 of %2 steps").arg(count(steps.made(at, level)), count(steps.count(at.stage, level)));
    return {QStringLiteral("Inside %1").arg(label), comma < 0 ? words : words.left(comma), made,
            formatOf(steps.frame()->scene()), defectOf(steps.frame()->scene())};
}

FrameStatus frameStatus(const pipeline::Frame& frame) {
    QStringList actions;
    if (const int n = countOf(frame, Action::Run)) actions += QStringLiteral("%1 ran").arg(n);
    if (const int n = countOf(frame, Action::Reuse)) actions += QStringLiteral("%1 reused").arg(n);
    if (const int n = countOf(frame, Action::LeaveOut)) actions += QStringLiteral("%1 left out").arg(n);
    return {QStringLiteral("Frame %1").arg(frame.number()), milliseconds(frame.milliseconds()),
            actions.join(QStringLiteral(", ")), formatOf(frame.scene()), defectOf(frame.scene())};
}

QString frameSentence(const pipeline::Frame& frame) {
    QStringList ran;
    QString why;
    for (const PlanStep& step : frame.plan()) {
        if (step.action != Action::Run) continue;
        if (ran.isEmpty()) why = toQString(step.why);
        ran += toQString(stageInfo(step.stage).label);
    }
    const int reused = countOf(frame, Action::Reuse);
    if (ran.isEmpty()) return QStringLiteral("Nothing that a stage reads has changed; all were reused.");
    if (why == toQString(pipeline::kNotRunYet)) {  // of a scene that has just been opened
        const int out = countOf(frame, Action::LeaveOut);
        return QStringLiteral("%1 stages ran in %2%3.")
            .arg(ran.size())
            .arg(milliseconds(frame.milliseconds()), out > 0 ? QStringLiteral(", %1 left out").arg(out) : QString());
    }
    const QString who = ran.size() == 1   ? ran.front()
                        : ran.size() == 2 ? ran.join(QStringLiteral(" and "))
                                          : QStringLiteral("%1 and %2 others").arg(ran.front()).arg(ran.size() - 1);
    // The plan's reason is a sentence; here it becomes a clause.
    if (why.endsWith(QLatin1Char('.'))) why.chop(1);
    if (!why.isEmpty()) why[0] = why[0].toLower();
    const QString rest = reused == 0   ? QString()
                         : reused == 1 ? QStringLiteral("; 1 stage was reused")
                                       : QStringLiteral("; %1 stages were reused").arg(reused);
    return QStringLiteral("%1 ran again because %2%3.").arg(who, why, rest);
}

}  // namespace app
