#pragma once
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/scene/scene.h"

class QCheckBox;
class QPushButton;

namespace app {

// The formats of an export: side by side those of a buffer, below them those whose one file holds the
// whole scene, in words. One that cannot hold this scene says why.
class ExportFormats : public QWidget {
    Q_OBJECT
public:
    explicit ExportFormats(const pipeline::Scene& scene, QWidget* parent = nullptr);

    std::vector<std::string> chosen() const;  // names, as --format takes them
    QStringList sceneFiles() const;           // "cube.gl.c": the files of the whole scene that are chosen

signals:
    void changed();

private:
    std::string m_sceneName;
    std::vector<QPushButton*> m_buffers;  // in the order of exporterTable
    std::vector<QCheckBox*> m_scene;      // in the order of frameExporterTable
};

}  // namespace app
