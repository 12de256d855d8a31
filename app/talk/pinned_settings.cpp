#include "app/talk/pinned_settings.h"

#include <QGridLayout>
#include <algorithm>

#include "app/settings/setting_row.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/number_field.h"

namespace app {

PinnedSettings::PinnedSettings(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    spaced(new QHBoxLayout(this), {});
    connect(&document, &Document::sceneChanged, this, &PinnedSettings::checkScene);
    connect(&document, &Document::sceneOpened, this, &PinnedSettings::build);
    hide();
}

void PinnedSettings::show(std::vector<std::string> keys) {
    m_keys = std::move(keys);
    build();
}

// A light or an object may have gone.
void PinnedSettings::checkScene() {
    if (!std::ranges::all_of(m_settings, [this](const auto& one) { return isIn(m_document.scene(), one); })) build();
}

void PinnedSettings::build() {
    m_settings.clear();
    delete m_rows;
    m_rows = new QWidget(this);
    layout()->addWidget(m_rows);
    auto* columns = spaced(new QHBoxLayout(m_rows), {});
    for (const std::string& key : m_keys) {
        if (!m_document.hasScene()) break;
        const auto setting = findSetting(m_document.scene(), key);
        if (!setting) continue;
        m_settings.push_back(*setting);
        auto* part = new QWidget(m_rows);
        auto* form = new QGridLayout(part);
        form->setContentsMargins(0, 0, 0, 0);
        form->setColumnStretch(1, 1);
        new SettingRow(m_document, *setting, *form, 0, part);
        columns->addWidget(part, 1);
    }
    for (QWidget* control : m_rows->findChildren<QWidget*>()) control->setFocusPolicy(Qt::NoFocus);
    for (NumberField* field : m_rows->findChildren<NumberField*>()) {
        field->setReadOnly(true);
        field->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    setVisible(!m_settings.empty());
}

}  // namespace app
