#pragma once
#include <QTabBar>
#include <QWidget>

#include "app/document/document.h"
#include "app/document/scene_outline.h"

class QLabel;
class QPushButton;
class QScrollArea;

namespace app {

class SettingRow;

// The settings of the selected thing on the first tab; shading, depth and shadow on the others.
// The controls are made from the table of settings. Below them: the last change, with a button that undoes it.
class SettingsPanel : public QWidget {
    Q_OBJECT
public:
    explicit SettingsPanel(Document& document, QWidget* parent = nullptr);

    void select(const SceneItem& item);    // and shows its tab
    void showSetting(const QString& key);  // its tab, with the keys going to its control

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();  // the controls of the tab on show
    void arrange();
    void foldIdle();
    void showLastChange();
    std::vector<pipeline::SettingRef> settingsOnShow() const;

    Document& m_document;
    SceneItem m_item;
    QTabBar* m_tabs;
    QScrollArea* m_scroll;
    QList<SettingRow*> m_rows;
    QPushButton* m_fold = nullptr;  // on the page in m_scroll
    bool m_unfolded = false;
    QLabel* m_changed;
};

}  // namespace app
