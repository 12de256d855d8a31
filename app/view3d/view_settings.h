#pragma once
#include <QWidget>

#include <utility>
#include <vector>

#include "app/drawing3d/view_options.h"
#include "app/drawing3d/view_space.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace app {

class FactorSlider;

// The small popup of a 3D view: which normals, how long, how many; how long the vectors; bounds,
// frustum, constructions.
class ViewSettings : public QWidget {
    Q_OBJECT
public:
    explicit ViewSettings(QWidget* parent = nullptr);
    void setOptions(const ViewOptions& options);  // says nothing
    void setSpace(ViewSpace space);               // what has no meaning there is disabled, with its reason

signals:
    void changed(const app::ViewOptions& options);

private:
    struct Row {
        FactorSlider* slider;
        QLabel* value;
    };
    Row addSlider(const QString& name, const QString& tip, double low, double high);
    void addSwitch(const QString& name, const QString& tip, bool ViewOptions::*shown);
    void addHeading(const QString& words);
    void applyTheme();
    void take();
    void showValues();

    ViewOptions m_options;
    QComboBox* addChoice(const QString& name, const QString& tip, const QStringList& choices);
    QComboBox *m_normals, *m_normalColors, *m_faces, *m_objectTool;
    std::vector<std::pair<QCheckBox*, bool ViewOptions::*>> m_switches;
    std::vector<QLabel*> m_headings;
    Row m_normalLength{}, m_every{}, m_vectorLength{};
};

}  // namespace app
