#include "app/commands/explain_actions.h"

#include <QApplication>
#include <QClipboard>

#include "app/buffer_view/buffer_copies.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/condition_bar.h"
#include "app/document/document.h"
#include "app/inspector/equation_section.h"
#include "app/inspector/inspector_panel.h"
#include "app/inspector/math_view.h"
#include "app/views/view_area.h"

namespace app {
namespace {

using A = ActionId;

struct EquationCopy {
    A id;
    const char *text, *keys, *tip;
    QString (MathView::*write)() const;
    const char* form;
};
constexpr EquationCopy kCopies[]{{A::CopyEquationText, "Copy equation as text", "Ctrl+Shift+C",
                                  "Copy the picked pixel's equation.", &MathView::asText, "text"},
                                 {A::CopyEquationMarkdown, "Copy equation as Markdown", "",
                                  "Copy it with its formulas between $$.", &MathView::asMarkdown, "Markdown"},
                                 {A::CopyEquationLatex, "Copy equation as LaTeX", "",
                                  "Copy it as an align* of amsmath.", &MathView::asLatex, "LaTeX"},
                                 {A::CopyEquationJson, "Copy equation as JSON", "",
                                  "Copy its lines as text and LaTeX, for programs.", &MathView::asJson, "JSON"}};

QString whyNoPixel(const Document& document) {
    return document.pointing().pixel() ? QString() : Document::tr("Pick a pixel first.");
}

QString whyNoEquation(const Document& document, const InspectorPanel& inspector) {
    if (inspector.report() && inspector.report()->covered) return {};
    return document.pointing().pixel() ? Document::tr("Nothing was drawn at this pixel.") : whyNoPixel(document);
}

void addCopies(Actions& actions, Document& document, InspectorPanel& inspector, ViewArea& views) {
    actions.add({.id = A::CopyValue,
                 .menu = "Edit",
                 .text = "Copy value",
                 .keys = "Alt+C",
                 .tip = "Copy the picked pixel's value in the buffer on show, with all its digits.",
                 .run = [&views] { views.activeBuffer().features().copies->copyValue(); },
                 .whyNot = [&document] { return whyNoPixel(document); },
                 .startsGroup = true});
    actions.add({.id = A::CopyPicture,
                 .menu = "Edit",
                 .text = "Copy picture",
                 .keys = "",
                 .tip = "Copy the buffer on show as a picture, a pixel each.",
                 .run = [&views] { views.activeBuffer().features().copies->copyPicture(); }});
    for (const EquationCopy& copy : kCopies)
        actions.add({.id = copy.id,
                     .menu = "Edit",
                     .text = copy.text,
                     .keys = copy.keys,
                     .tip = copy.tip,
                     .run =
                         [&document, &inspector, copy] {
                             QApplication::clipboard()->setText((inspector.equation().math()->*copy.write)());
                             emit document.said(Document::tr("Copied the equation as %1.").arg(copy.form));
                         },
                     .whyNot = [&document, &inspector] { return whyNoEquation(document, inspector); }});
}

}  // namespace

void addExplainActions(Actions& actions, Document& document, InspectorPanel& inspector, ViewArea& views) {
    addCopies(actions, document, inspector, views);
    EquationSection& equation = inspector.equation();
    actions.add({.id = A::KeepResult,
                 .menu = "Edit",
                 .text = "Keep the result before",
                 .keys = "Alt+K",
                 .tip = "Keep what the picked pixel's intensity was before the last change, or drop it.",
                 .run = [&equation] { equation.setKept(!equation.keeps()); },
                 .whyNot =
                     [&document, &inspector, &equation] {
                         const QString why = whyNoEquation(document, inspector);
                         if (!why.isEmpty() || equation.canKeep()) return why;
                         return Document::tr("Nothing has changed the result since the pixel was picked.");
                     },
                 .isOn = [&equation] { return equation.keeps(); }});
    QObject::connect(&equation, &EquationSection::keptChanged, &actions, &Actions::refresh);
    actions.add({.id = A::StopWhere,
                 .menu = "Run",
                 .text = "Stop where…",
                 .keys = "Ctrl+Shift+F10",
                 .tip = "Go on until a condition begins to hold at a pixel; ask for the condition first.",
                 .run = [&views] {
                     ConditionBar& condition = views.activeBuffer().condition();
                     condition.isVisible() && condition.hasCondition() ? condition.runToStop() : condition.open();
                 }});
    actions.add({.id = A::Condition,
                 .menu = "Inspect",
                 .text = "Condition…",
                 .keys = "Ctrl+/",
                 .tip = "Ask a question of every pixel: n_dot_l.0 > 0.9 && x < 300.",
                 .run = [&views] { views.activeBuffer().condition().open(); }});
}

}  // namespace app
