#pragma once
#include <QWidget>
#include <string>
#include <vector>

#include "app/document/document.h"

namespace app {

// The settings that a cue pins to the clean view, side by side. They are moved with the mouse alone: the keys stay those
// of the talk.
class PinnedSettings : public QWidget {
    Q_OBJECT
public:
    explicit PinnedSettings(Document& document, QWidget* parent = nullptr);

    void show(std::vector<std::string> keys);  // those that the scene does not have are left out
    std::size_t count() const { return m_settings.size(); }

private:
    void build();
    void checkScene();

    Document& m_document;
    std::vector<std::string> m_keys;
    std::vector<pipeline::SettingRef> m_settings;
    QWidget* m_rows = nullptr;
};

}  // namespace app
