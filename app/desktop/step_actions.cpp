#include "app/desktop/step_actions.h"

#include <algorithm>

namespace app {
namespace {

using A = ActionId;

constexpr std::array kBookmarks{A::Bookmark1, A::Bookmark2, A::Bookmark3, A::Bookmark4, A::Bookmark5,
                                A::Bookmark6, A::Bookmark7, A::Bookmark8, A::Bookmark9};

// What comes next for the picked pixel or the selection; nothing where that is neither.
std::optional<pipeline::Moment> aim(const Document& document) {
    const pipeline::Steps* steps = document.stepper().steps().get();
    if (!steps) return std::nullopt;
    // From the end of the frame, from the beginning.
    const pipeline::Moment from = document.stepper().isInside() ? *document.stepper().moment() : steps->first();
    if (const auto& selection = document.pointing().selection()) {
        using Kind = lessons::Selection::Kind;
        using Thing = pipeline::Steps::Thing;
        if (selection->kind == Kind::Light) return std::nullopt;
        const Thing thing = selection->kind == Kind::Object    ? Thing::Object
                            : selection->kind == Kind::Polygon ? Thing::Polygon
                                                               : Thing::Vertex;
        return steps->nextAt(from, thing, std::uint32_t(selection->index));
    }
    return document.pointing().pixel() ? steps->nextAt(from, *document.pointing().pixel()) : std::nullopt;
}

void runToSelection(Document& document) {
    if (const auto there = aim(document))
        document.stepper().goTo(*there);
    else
        emit document.said(Document::tr("Nothing more happens to it."));
}

}  // namespace

void connectStepActions(const Actions& actions, Document& document) {
    Stepper& stepper = document.stepper();
    const auto on = [&](A id, auto run) { QObject::connect(actions[id], &QAction::triggered, &stepper, run); };
    on(A::Play, [&stepper] { stepper.setPlaying(!stepper.isPlaying()); });
    on(A::StepOn, [&stepper] { stepper.step(1); });
    on(A::StepBack, [&stepper] { stepper.step(-1); });
    on(A::RunToSelection, [&document] { runToSelection(document); });
    on(A::FirstStep, [&stepper] { stepper.toFirst(); });
    on(A::LastStep, [&stepper] { stepper.toLast(); });
    on(A::Bookmark, [&stepper] { stepper.toggleBookmark(); });
    for (std::size_t i = 0; i < kBookmarks.size(); ++i)
        on(kBookmarks[i], [&stepper, i] {
            if (i < stepper.bookmarks().size()) stepper.goTo(stepper.bookmarks()[i]);
        });
}

void enableStepActions(Actions& actions, const Document& document, bool hasScene) {
    const Stepper& stepper = document.stepper();
    const QString noScene = Document::tr("Open a scene first.");
    const auto enable = [&](A id, bool can, const QString& whyNot) {
        actions.setEnabled(id, hasScene && can, hasScene ? whyNot : noScene);
    };
    const bool first = stepper.isInside() && !stepper.canStep(-1);
    enable(A::Play, true, {});
    actions[A::Play]->setChecked(stepper.isPlaying());  // it ends by itself too
    actions[A::Play]->setText(stepper.isPlaying() ? Document::tr("Pause") : Document::tr("Play"));
    enable(A::StepOn, stepper.canStep(1), Document::tr("Already at the last step; Home goes to the first."));
    enable(A::StepBack, stepper.canStep(-1), Document::tr("Already at the first step."));
    enable(A::FirstStep, !first, Document::tr("Already at the first step."));
    enable(A::LastStep, stepper.isInside(), Document::tr("The whole frame is on show."));
    const bool selected =
        document.pointing().pixel() ||
        (document.pointing().selection() && document.pointing().selection()->kind != lessons::Selection::Kind::Light);
    enable(A::RunToSelection, selected, Document::tr("Pick a pixel, or select a polygon, an object or a vertex."));
    enable(A::Bookmark, stepper.isInside(), Document::tr("The whole frame is on show; step inside it first."));
    actions[A::Bookmark]->setChecked(stepper.bookmarkHere() >= 0);
    actions[A::Bookmark]->setText(stepper.bookmarkHere() >= 0 ? Document::tr("Remove the bookmark")
                                                              : Document::tr("Bookmark"));
    for (std::size_t i = 0; i < kBookmarks.size(); ++i)
        enable(kBookmarks[i], i < stepper.bookmarks().size(), Document::tr("There is no such bookmark."));
}

Timeline::Transport transportOf(const Actions& actions) {
    return {actions[A::FirstStep], actions[A::StepBack], actions[A::Play], actions[A::StepOn], actions[A::LastStep]};
}

}  // namespace app
