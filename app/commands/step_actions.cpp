#include "app/commands/step_actions.h"

#include <iterator>

namespace app {
namespace {

using A = ActionId;

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

QString whyNotForward(const Stepper& stepper) {
    return stepper.canStep(1) ? QString() : Document::tr("Already at the last step; Home goes to the first.");
}

QString whyNotBackward(const Stepper& stepper) {
    const bool atFirst = stepper.isInside() && !stepper.canStep(-1);
    return atFirst ? Document::tr("Already at the first step.") : QString();
}

QString whyNotToSelection(const Document& document) {
    const auto& selection = document.pointing().selection();
    const bool selected =
        document.pointing().pixel() || (selection && selection->kind != lessons::Selection::Kind::Light);
    return selected ? QString() : Document::tr("Pick a pixel, or select a polygon, an object or a vertex.");
}

void addTransport(Actions& actions, Document& document) {
    Stepper& stepper = document.stepper();
    actions.add({.id = A::Play,
                 .menu = "Run",
                 .text = "Play",
                 .keys = "Space",
                 .tip = "Play step after step, or stop.",
                 .run = [&stepper] { stepper.setPlaying(!stepper.isPlaying()); },
                 .isOn = [&stepper] { return stepper.isPlaying(); },  // it ends by itself too
                 .name = [&stepper] { return stepper.isPlaying() ? Document::tr("Pause") : Document::tr("Play"); },
                 .startsGroup = true,
                 .inTalk = true});
    actions.add({.id = A::StepOn,
                 .menu = "Run",
                 .text = "Step",
                 .keys = "F10",
                 .tip = "Make one step, as far as the timeline says.",
                 .run = [&stepper] { stepper.step(1); },
                 .whyNot = [&stepper] { return whyNotForward(stepper); },
                 .inTalk = true});
    actions.add(
        {.id = A::StepBack,
         .menu = "Run",
         .text = "Step back",
         .keys = "Shift+F10",
         .tip = "Take one step back, exactly.",
         .run = [&stepper] { stepper.step(-1); },
         .whyNot = [&stepper] { return stepper.canStep(-1) ? QString() : Document::tr("Already at the first step."); },
         .inTalk = true});
    actions.add({.id = A::FirstStep,
                 .menu = "Run",
                 .text = "First step",
                 .keys = "Home",
                 .tip = "Go to before the first step: nothing has run.",
                 .run = [&stepper] { stepper.toFirst(); },
                 .whyNot = [&stepper] { return whyNotBackward(stepper); },
                 .inTalk = true});
    actions.add(
        {.id = A::LastStep,
         .menu = "Run",
         .text = "Whole frame",
         .keys = "End",
         .tip = "Go to the end of the frame.",
         .run = [&stepper] { stepper.toLast(); },
         .whyNot = [&stepper] { return stepper.isInside() ? QString() : Document::tr("The whole frame is on show."); },
         .inTalk = true});
    actions.add({.id = A::RunToSelection,
                 .menu = "Run",
                 .text = "Run to the selection",
                 .keys = "Ctrl+F10",
                 .tip = "Go on until something happens to the picked pixel, or to what is selected.",
                 .run = [&document] { runToSelection(document); },
                 .whyNot = [&document] { return whyNotToSelection(document); },
                 .inTalk = true});
}

void addBookmarks(Actions& actions, Stepper& stepper) {
    actions.add({.id = A::Bookmark,
                 .menu = "Run",
                 .text = "Bookmark",
                 .keys = "Ctrl+Shift+B",
                 .tip = "Set a bookmark here, or remove it.",
                 .run = [&stepper] { stepper.toggleBookmark(); },
                 .whyNot =
                     [&stepper] {
                         return stepper.isInside() ? QString()
                                                   : Document::tr("The whole frame is on show; step inside it first.");
                     },
                 .isOn = [&stepper] { return stepper.bookmarkHere() >= 0; },
                 .name =
                     [&stepper] {
                         return stepper.bookmarkHere() >= 0 ? Document::tr("Remove the bookmark")
                                                            : Document::tr("Bookmark");
                     },
                 .startsGroup = true});
    struct Numbered {
        A id;
        const char *text, *keys;
    };
    static constexpr Numbered kBookmarks[]{
        {A::Bookmark1, "Bookmark 1", "Ctrl+1"}, {A::Bookmark2, "Bookmark 2", "Ctrl+2"},
        {A::Bookmark3, "Bookmark 3", "Ctrl+3"}, {A::Bookmark4, "Bookmark 4", "Ctrl+4"},
        {A::Bookmark5, "Bookmark 5", "Ctrl+5"}, {A::Bookmark6, "Bookmark 6", "Ctrl+6"},
        {A::Bookmark7, "Bookmark 7", "Ctrl+7"}, {A::Bookmark8, "Bookmark 8", "Ctrl+8"},
        {A::Bookmark9, "Bookmark 9", "Ctrl+9"}};
    for (std::size_t i = 0; i < std::size(kBookmarks); ++i)
        actions.add({.id = kBookmarks[i].id,
                     .menu = "Run/Bookmarks",
                     .text = kBookmarks[i].text,
                     .keys = kBookmarks[i].keys,
                     .tip = "Go to the bookmark.",
                     .run = [&stepper, i] { stepper.goTo(stepper.bookmarks()[i]); },
                     .whyNot =
                         [&stepper, i] {
                             return i < stepper.bookmarks().size() ? QString()
                                                                   : Document::tr("There is no such bookmark.");
                         },
                     .inTalk = true});
}

}  // namespace

void addStepActions(Actions& actions, Document& document) {
    addTransport(actions, document);
    addBookmarks(actions, document.stepper());
}

Timeline::Transport transportOf(const Actions& actions) {
    return {actions[A::FirstStep], actions[A::StepBack], actions[A::Play], actions[A::StepOn], actions[A::LastStep]};
}

}  // namespace app
