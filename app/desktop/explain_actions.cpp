#include "app/desktop/explain_actions.h"

#include <QApplication>
#include <QClipboard>

#include "app/core/document.h"
#include "app/desktop/view_area.h"
#include "app/panels/buffer_copies.h"
#include "app/panels/buffer_view.h"
#include "app/panels/condition_bar.h"
#include "app/panels/equation_section.h"
#include "app/panels/inspector_panel.h"
#include "app/panels/math_view.h"

namespace app {
namespace {

using A = ActionId;

struct Copy {
    A id;
    QString (MathView::*write)() const;
    const char* form;
};
constexpr std::array kCopies{Copy{A::CopyEquationText, &MathView::asText, "text"},
                             Copy{A::CopyEquationMarkdown, &MathView::asMarkdown, "Markdown"},
                             Copy{A::CopyEquationLatex, &MathView::asLatex, "LaTeX"},
                             Copy{A::CopyEquationJson, &MathView::asJson, "JSON"}};

}  // namespace

void connectExplainActions(Actions& actions, Document& document, InspectorPanel& inspector, ViewArea& views) {
    for (const Copy& copy : kCopies)
        QObject::connect(actions[copy.id], &QAction::triggered, &inspector, [&document, &inspector, copy] {
            QApplication::clipboard()->setText((inspector.equation().math()->*copy.write)());
            emit document.said(Document::tr("Copied the equation as %1.").arg(copy.form));
        });
    QObject::connect(actions[A::Condition], &QAction::triggered, &views,
                     [&views] { views.activeBuffer().condition().open(); });
    QObject::connect(actions[A::CopyValue], &QAction::triggered, &views,
                     [&views] { views.activeBuffer().features().copies->copyValue(); });
    QObject::connect(actions[A::CopyPicture], &QAction::triggered, &views,
                     [&views] { views.activeBuffer().features().copies->copyPicture(); });
    QObject::connect(actions[A::StopWhere], &QAction::triggered, &views, [&views] {
        ConditionBar& condition = views.activeBuffer().condition();
        condition.isVisible() && condition.hasCondition() ? condition.runToStop() : condition.open();
    });
    EquationSection& equation = inspector.equation();
    QObject::connect(actions[A::KeepResult], &QAction::triggered, &equation, &EquationSection::setKept);
    QObject::connect(&equation, &EquationSection::keptChanged, &actions, [&actions, &document, &inspector] {
        enableExplainActions(actions, document, inspector, document.hasScene());
    });
}

void enableExplainActions(Actions& actions, const Document& document, InspectorPanel& inspector, bool hasScene) {
    const auto enable = [&](A id, bool can, const QString& whyNot) {
        actions.setEnabled(id, hasScene && can, hasScene ? whyNot : Document::tr("Open a scene first."));
    };
    const bool covered = inspector.report() && inspector.report()->covered;
    const QString noEquation = document.pointing().pixel() ? Document::tr("Nothing was drawn at this pixel.")
                                                           : Document::tr("Pick a pixel first.");
    for (const Copy& copy : kCopies) enable(copy.id, covered, noEquation);
    for (const A id : {A::Condition, A::StopWhere, A::CopyPicture}) enable(id, true, {});
    enable(A::CopyValue, document.pointing().pixel().has_value(), Document::tr("Pick a pixel first."));
    const EquationSection& equation = inspector.equation();
    enable(A::KeepResult, covered && equation.canKeep(),
           covered ? Document::tr("Nothing has changed the result since the pixel was picked.") : noEquation);
    actions[A::KeepResult]->setChecked(equation.keeps());
}

}  // namespace app
