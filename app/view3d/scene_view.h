#pragma once
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/view3d/shown_space.h"
#include "app/view3d/view_camera.h"
#include "app/view3d/view_corners.h"
#include "app/view3d/view_handles.h"
#include "app/view3d/view_input.h"
#include "app/view3d/view_progress.h"
#include "app/vtk/offscreen.h"
#include "app/vtk/vtk_widget.h"

class QLabel;

namespace app {

// A 3D view: what VTK renders, and over it letters, handles and corners. Each of its parts does one thing.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    ShownSpace& space() const { return *m_space; }
    ViewCamera& camera() const { return *m_camera; }
    ViewHandles& handles() const { return *m_handles; }
    ViewInput& input() const { return *m_input; }
    ViewCorners& corners() const { return *m_corners; }
    ViewProgress& progress() const { return *m_progress; }

    void setEmptyText(const QString& sentence);
    void setOptions(const ViewOptions& options);
    void changeOptions(const ViewOptions& options);  // by the view itself
    const ViewOptions& options() const { return m_options; }
    // Draws these vectors strongly, the others faintly, and shows them even where they are switched off; an empty list
    // ends that. Another view calls it while its cursor is on them.
    void pointAt(const std::vector<VectorCode>& codes);
    // A point of the world that another view's cursor is on, marked lightly.
    void setProbe(std::optional<Vec3d> point);

    // A description from which the view's picture can be made in another size. Errors: nothing to show.
    pipeline::Result<SpacePicture> picture(QSize size, bool transparent) const;
    ViewFrame viewFrame() const;
    const Drawing& drawing() const { return m_drawing; }
    // Whether the picture on show has everything that was set. Pictures are made on another thread; drawn() announces each.
    bool isDrawn() const { return !m_vtk || m_vtk->isDrawn(); }
    // Why nothing is rendered here; empty where it works.
    QString problem() const { return m_problem; }

    void render(std::shared_ptr<const ViewContent> content, const std::vector<InkedLine>& ground);
    void refresh();  // after a change of camera, content, options or theme
    void updateOverlay();
    void updateWithPicture();  // paints letters and handles together with the picture that is being made

signals:
    void drawn();
    void optionsChanged();  // by the view itself

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    class Overlay;

    void applyTheme();
    void place();
    QString sentence() const;

    QString m_emptyText;
    std::optional<Vec3d> m_probe;
    std::vector<VectorCode> m_pointedAt;  // under the cursor in the legend or the equation
    ViewOptions m_options;
    Drawing m_drawing;
    QString m_problem;

    VtkWidget* m_vtk = nullptr;  // null where there is no OpenGL
    QWidget* m_overlay;
    QLabel* m_sentence;
    std::unique_ptr<ShownSpace> m_space;
    std::unique_ptr<ViewCamera> m_camera;
    std::unique_ptr<ViewHandles> m_handles;
    std::unique_ptr<ViewInput> m_input;
    std::unique_ptr<ViewCorners> m_corners;
    std::unique_ptr<ViewProgress> m_progress;
};

}  // namespace app
