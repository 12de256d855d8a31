#include "app/desktop/stage_actions.h"

#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "app/commands/actions.h"
#include "app/commands/pixel_field.h"
#include "app/desktop/exports.h"
#include "app/document/document.h"
#include "app/stages/contract_list.h"
#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/views/view_area.h"

namespace app {

StageActions::StageActions(QWidget& window, Actions& actions, Document& document, ViewArea& views, StageStrip& strip)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_views(views),
      m_strip(strip),
      m_pixelField(new PixelField(&window)) {
    addStages(actions);
    addPixels(actions);
    addChannels(actions);
    connect(m_pixelField, &PixelField::entered, this, [this](glm::ivec2 pixel) {
        m_document.pointing().pick(pixel);
        m_views.activeBuffer().takeKeys();  // whose arrows move it on
    });
}

void StageActions::addStages(Actions& actions) {
    using A = ActionId;
    using pipeline::StageId;
    actions.add({.id = A::NextStage,
                 .menu = "Run",
                 .text = "Next stage",
                 .keys = "Ctrl+Right",
                 .tip = "Go to the end of the stage after this one.",
                 .run = [this] { m_document.nextStage(); },
                 .whyNot =
                     [this] {
                         const bool isLast = m_document.stage() == StageId::Shading && !m_document.stepper().isInside();
                         return isLast ? tr("Already at the last stage; Ctrl+← goes back.") : QString();
                     },
                 .inTalk = true});
    actions.add({.id = A::PreviousStage,
                 .menu = "Run",
                 .text = "Previous stage",
                 .keys = "Ctrl+Left",
                 .tip = "Go to the end of the stage before this one.",
                 .run = [this] { m_document.previousStage(); },
                 .whyNot =
                     [this] {
                         const bool isFirst = m_document.stage() == StageId::Transform;
                         return isFirst ? tr("Already at the first stage; Ctrl+→ goes on.") : QString();
                     },
                 .inTalk = true});
    struct Choice {
        A id;
        const char *text, *keys, *tip;
        StageId stage;
    };
    static constexpr Choice kStages[]{
        {A::Transform, "Transform", "Alt+1", "Show the vertices on the screen.", StageId::Transform},
        {A::Cull, "Cull", "Alt+2", "Show which polygons are kept.", StageId::Cull},
        {A::Normals, "Normals", "Alt+3", "Show which way the surface faces.", StageId::Normals},
        {A::ShadowBuffer, "Shadow buffer", "Alt+4", "Show the depth that a light sees.", StageId::ShadowBuffer},
        {A::ZBuffer, "Z-buffer", "Alt+5", "Show the nearest depth at every pixel.", StageId::ZBuffer},
        {A::Shading, "Shading", "Alt+6", "Show the frame buffer.", StageId::Shading}};
    std::vector<ActionRow> rows;
    for (const Choice& choice : kStages)
        rows.push_back({.id = choice.id,
                        .menu = "Run",
                        .text = choice.text,
                        .keys = choice.keys,
                        .tip = choice.tip,
                        .run = [this, stage = choice.stage] { m_document.setStage(stage); },
                        .isOn = [this, stage = choice.stage] { return m_document.stage() == stage; },
                        .startsGroup = rows.empty(),
                        .inTalk = true});
    actions.addChoices(std::move(rows));
    actions.add({.id = A::Contracts,
                 .menu = "Inspect",
                 .text = "Contracts",
                 .keys = "K",
                 .tip = "List what must hold of this stage's output, and whether it does.",
                 .run = [this] { showContracts(); },
                 .whyNot = [this] { return whyNoValues(m_document); }});
}

void StageActions::addPixels(Actions& actions) {
    actions.add({.id = ActionId::GoToPixel,
                 .menu = "Inspect",
                 .text = "Go to pixel…",
                 .keys = "Ctrl+G",
                 .tip = "Pick a pixel by its column and row.",
                 .run = [this] { goToPixel(); }});
    actions.add({.id = ActionId::Unpick,
                 .menu = "Inspect",
                 .text = "Clear selection",
                 .keys = "Ctrl+Shift+G",
                 .tip = "Clear the picked pixel and the selected object, light, polygon or vertex.",
                 .run =
                     [this] {
                         m_document.pointing().pick(std::nullopt);
                         m_document.pointing().select(std::nullopt);
                     },
                 .whyNot =
                     [this] {
                         const Pointing& pointing = m_document.pointing();
                         return pointing.pixel() || pointing.selection()
                                    ? QString()
                                    : tr("No pixel is picked, and nothing is selected.");
                     }});
}

void StageActions::addChannels(Actions& actions) {
    using A = ActionId;
    struct Choice {
        A id;
        const char *text, *keys, *tip;
        int channel;
    };
    static constexpr Choice kChannels[]{
        {A::RedChannel, "Equation in red", "Alt+R", "Write the equation of the red part.", 0},
        {A::GreenChannel, "Equation in green", "Alt+G", "Write the equation of the green part.", 1},
        {A::BlueChannel, "Equation in blue", "Alt+B", "Write the equation of the blue part.", 2}};
    std::vector<ActionRow> rows;
    for (const Choice& choice : kChannels)
        rows.push_back({.id = choice.id,
                        .menu = "Inspect",
                        .text = choice.text,
                        .keys = choice.keys,
                        .tip = choice.tip,
                        .run = [this, channel = choice.channel] { m_document.pointing().setChannel(channel); },
                        .isOn = [this, channel = choice.channel] { return m_document.pointing().channel() == channel; },
                        .startsGroup = rows.empty(),
                        .inTalk = true});
    actions.addChoices(std::move(rows));
}

void StageActions::goToPixel() {
    const auto& settings = m_document.scene().settings;
    m_pixelField->open({settings.width, settings.height}, m_document.pointing().pixel());
}

// Below the card of the stage on show.
void StageActions::showContracts() {
    if (!m_contracts) {
        m_contracts = new ContractList(m_document, &m_window);
        connect(m_contracts, &ContractList::violatorsAsked, this,
                [this](const pipeline::BufferName& buffer, std::optional<glm::ivec2> worst) {
                    BufferView& view = m_views.activeBuffer();
                    view.setBuffer(buffer);
                    view.features().overlays->set(OverlayId::Violators, true);
                    if (worst) m_document.pointing().pick(worst);
                });
    }
    const QWidget& card = m_strip.card(m_document.stage());
    m_contracts->open(card.mapToGlobal(QPoint(0, card.height() + 2)), m_document.stage());
}

}  // namespace app
