#include "app/bug_game/bug_own.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/widgets/follow_theme.h"
#include "lessons/games/wrong_picture.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"

namespace app {

BugOwnDialog::BugOwnDialog(std::shared_ptr<const pipeline::Scene> open, QWidget* parent)
    : QDialog(parent),
      m_open(std::move(open)),
      m_scenes(new QComboBox(this)),
      m_defects(new QComboBox(this)),
      m_words(styled(new QLabel(this), {.tone = 2, .wraps = true})) {
    setObjectName("bugOwnDialog");
    setWindowTitle(tr("Set a picture"));
    m_scenes->setObjectName("bugOwnScene");
    m_defects->setObjectName("bugOwnDefect");
    if (m_open) m_scenes->addItem(tr("%1 (open in the window)").arg(toQString(m_open->name)));
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes())
        m_scenes->addItem(toQString(scene.title), toQString(scene.file.string()));
    for (const pipeline::DefectRow& row : pipeline::defectTable())
        if (row.inGame)
            m_defects->addItem(
                QStringLiteral("%1: %2").arg(toQString(lessons::boxLabel(lessons::boxOf(row))), toQString(row.name)),
                int(row.id));
    const auto showSymptom = [this] {
        m_words->setText(toQString(defectInfo(pipeline::Defect(m_defects->currentData().toInt())).symptom));
    };
    connect(m_defects, &QComboBox::currentIndexChanged, this, showSymptom);
    showSymptom();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Cancel)->setIcon({});
    buttons->addButton(tr("Begin"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &BugOwnDialog::choose);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Scene"), m_scenes);
    form->addRow(tr("Error"), m_defects);
    form->addRow(m_words);
    form->addRow(buttons);
    m_words->setMinimumHeight(2 * fontMetrics().lineSpacing());
    setMinimumWidth(Theme::current().px(480));
}

// If a scene's file cannot be read, the dialog says why in place of the symptom.
void BugOwnDialog::choose() {
    auto scene = m_open;
    if (const QString file = m_scenes->currentData().toString(); !file.isEmpty()) {
        auto read = pipeline::readScene(file.toStdString());
        if (!read) return m_words->setText(toQString(format(read.errors())));
        scene = std::make_shared<const pipeline::Scene>(std::move(read).value());
    }
    emit chosen(scene, pipeline::Defect(m_defects->currentData().toInt()));
    accept();
}

}  // namespace app
