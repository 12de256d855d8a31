#include "app/commands/look_actions.h"

#include <QWidget>
#include <utility>

#include "app/commands/actions.h"
#include "app/look/theme.h"

namespace app {

LookActions::LookActions(QWidget& window, Actions& actions) : QObject(&window) {
    m_grows.setSingleShot(true);
    m_grows.setInterval(0);
    connect(&m_grows, &QTimer::timeout, this, [this] {
        if (m_growth != 0) growText(0);
    });
    addThemes(actions);
    addTextSizes(actions);
    connect(&Theme::current(), &Theme::changed, &actions, &Actions::refresh);
}

void LookActions::addThemes(Actions& actions) {
    struct Choice {
        ActionId id;
        const char *text, *tip;
        ThemeId theme;
    };
    static constexpr Choice kThemes[]{
        {ActionId::DarkTheme, "Dark", "Light letters on a dark ground.", ThemeId::Dark},
        {ActionId::LightTheme, "Light", "Dark letters on a light ground.", ThemeId::Light},
        {ActionId::ProjectorTheme, "Projector", "Black on white, larger.", ThemeId::Projector}};
    std::vector<ActionRow> rows;
    for (const Choice& choice : kThemes)
        rows.push_back({.id = choice.id,
                        .menu = "View/Theme",
                        .text = choice.text,
                        .keys = "",
                        .tip = choice.tip,
                        .run = [theme = choice.theme] { Theme::current().set(theme); },
                        .isOn = [theme = choice.theme] { return Theme::current().id() == theme; },
                        .needsScene = false,
                        .startsGroup = rows.empty(),
                        .inTalk = true});
    actions.addChoices(std::move(rows));
}

void LookActions::addTextSizes(Actions& actions) {
    actions.add({.id = ActionId::LargerText,
                 .menu = "View",
                 .text = "Larger text",
                 .keys = "Ctrl+Shift++; Ctrl+Shift+=",
                 .tip = "Make everything but the pictures larger.",
                 .run = [this] { growText(0.05); },
                 .needsScene = false});
    actions.add({.id = ActionId::SmallerText,
                 .menu = "View",
                 .text = "Smaller text",
                 .keys = "Ctrl+Shift+-; Ctrl+Shift+_",
                 .tip = "Make everything but the pictures smaller.",
                 .run = [this] { growText(-0.05); },
                 .needsScene = false});
}

// The first step at once, what comes while the window is laid out anew in one: a held key would else queue up for seconds.
void LookActions::growText(double by) {
    m_growth += by;
    if (m_grows.isActive()) return;
    Theme::current().setScale(Theme::current().scale() + std::exchange(m_growth, 0));
    m_grows.start();
}

}  // namespace app
