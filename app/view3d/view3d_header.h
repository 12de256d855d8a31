#pragma once
#include <QWidget>
#include <vector>

#include "app/document/document.h"
#include "app/drawing3d/light_frustum.h"
#include "app/view3d/scene_view.h"

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace app {

// The header of a 3D view: its space, the face of a point light, what is drawn, cameras and settings.
class View3dHeader : public QWidget {
    Q_OBJECT
public:
    View3dHeader(const Document& document, SceneView& view, QWidget* panel);

    QMenu* menu() const { return m_menu; }  // of its last button
    void arrange();                         // in the panel's width
    void showSpace();
    void showFace();
    void showOptions();
    void showToggles();  // what each shows, or why it shows nothing in this space

signals:
    void spaceChosen(app::SpaceId space);
    void optionsChosen(const app::ViewOptions& options);

private:
    QMenu* addChoice(QToolButton* button);
    QToolButton* addButton(const QString& icon, const QString& name, const QString& tip);
    QToolButton* addToggle(const QString& icon, const QString& name, const QString& tip);
    void addSpace();
    void addToggles();
    void addCameras();
    void addMenus();
    void addSpares();
    void fillSpaces(QMenu& menu);
    void fillFaces(QMenu& menu);
    void applyTheme();
    struct Names {
        QString space, face;
    };
    Names namesIn(bool areShort) const;
    QString normalsTip() const;

    const Document& m_document;
    SceneView& m_view;
    QToolButton *m_space, *m_face;
    QLabel* m_remark;
    QToolButton *m_cameras, *m_orthographic, *m_normals, *m_vectors, *m_lights, *m_eye;
    QMenu* m_menu;
    // What a narrow header can do without, the first one first: then it is in the menu.
    struct Spare {
        QToolButton* button;
        QAction* entry;
    };
    std::vector<Spare> m_spares;
    NormalsShown m_lastNormals = NormalsShown::Polygons;  // what the toggle brings back
};

}  // namespace app
