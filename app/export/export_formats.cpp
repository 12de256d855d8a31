#include "app/export/export_formats.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/wrapping_check_box.h"
#include "pipeline/export/buffers/exporter.h"

namespace app {

ExportFormats::ExportFormats(const pipeline::Scene& scene, QWidget* parent) : QWidget(parent), m_sceneName(scene.name) {
    auto* row = spaced(new QHBoxLayout, {}, 0);
    for (const pipeline::Exporter& exporter : pipeline::exporterTable()) {
        auto* button = new QPushButton(toQString(exporter.name), this);
        button->setCheckable(true);
        button->setChecked(exporter.name == "npy" || exporter.name == "png");
        button->setProperty("kind", "segment");
        button->setToolTip(toQString(exporter.meaning));
        connect(button, &QPushButton::toggled, this, &ExportFormats::changed);
        row->addWidget(button, 1);
        m_buffers.push_back(button);
    }
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addLayout(row);
    for (const pipeline::FrameExporter& exporter : pipeline::frameExporterTable()) {
        auto* box = new WrappingCheckBox(toQString(exporter.meaning).chopped(1), this);  // without its full stop
        box->setObjectName("format:" + toQString(exporter.name));
        const QString whyNot = toQString(exporter.refuses(scene));
        box->setEnabled(whyNot.isEmpty());
        box->setToolTip(whyNot.isEmpty() ? tr("One file: %1").arg(toQString(sceneFileName(scene.name, exporter)))
                                         : whyNot);
        connect(box, &QCheckBox::toggled, this, &ExportFormats::changed);
        column->addWidget(box);
        m_scene.push_back(box);
        if (whyNot.isEmpty()) continue;
        auto* why = styled(new QLabel(whyNot + '.', this), {.tone = 3, .wraps = true});
        column->addWidget(why);
        followTheme(why, [why] { why->setFont(Theme::current().text(12)); });
    }
    followTheme(this, [column] { column->setSpacing(Theme::current().px(6)); });
}

std::vector<std::string> ExportFormats::chosen() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < m_buffers.size(); ++i)
        if (m_buffers[i]->isChecked()) names.emplace_back(pipeline::exporterTable()[i].name);
    for (std::size_t i = 0; i < m_scene.size(); ++i)
        if (m_scene[i]->isChecked()) names.emplace_back(pipeline::frameExporterTable()[i].name);
    return names;
}

QStringList ExportFormats::sceneFiles() const {
    QStringList files;
    for (std::size_t i = 0; i < m_scene.size(); ++i)
        if (m_scene[i]->isChecked()) files << toQString(sceneFileName(m_sceneName, pipeline::frameExporterTable()[i]));
    return files;
}

}  // namespace app
