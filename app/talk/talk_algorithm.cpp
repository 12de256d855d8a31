#include "app/talk/talk_algorithm.h"

#include <QLabel>
#include <QVBoxLayout>

#include "app/document/document.h"
#include "app/look/text.h"
#include "app/tables/algorithm_panel.h"
#include "app/tables/algorithm_view.h"
#include "app/tables/step_tables.h"
#include "app/widgets/follow_theme.h"
#include "lessons/pages/talk_words.h"

namespace app {

TalkAlgorithm::TalkAlgorithm(const Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_lines(new AlgorithmView(this)),
      m_tables(new StepTables(document, this)),
      m_leftOut(styled(new QLabel(this), {.name = "algorithmLeftOut", .tone = 2, .wraps = true})) {
    m_lines->setLetters(20.8, 17.6);  // 38 and 32 px in 1080 lines
    m_tables->setLetters(19.7);       // 36 px
    m_lines->setMostLines(int(lessons::kMostAlgorithmRows));
    m_lines->setShowsLoop(true);
    m_lines->setFocusPolicy(Qt::NoFocus);
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addWidget(m_lines);
    column->addWidget(m_tables, 1000);
    column->addWidget(m_leftOut);
    column->addStretch(1);
    followTheme(this, [this] { m_leftOut->setFont(Theme::current().text(12)); });
}

void TalkAlgorithm::showStep(bool wanted) {
    const Stepper& stepper = m_document.stepper();
    auto state = stepper.showsAlgorithm() ? algorithmState(stepper, m_document.stage()) : std::nullopt;
    setVisible(state.has_value() && wanted);
    QStringList why;
    if (state)
        for (const std::string& sentence : state->leftOut()) why += toQString(sentence);
    m_leftOut->setText(why.join('\n'));
    m_leftOut->setVisible(!why.isEmpty());
    m_lines->setState(std::move(state));
    m_tables->showStep(m_lines->rows());
}

}  // namespace app
