#pragma once
#include <QWidget>

namespace app {

enum class SaveChanges { Save, Discard, Cancel };
// "Save the changes to pyramid.scene?", over `window`; Esc cancels.
SaveChanges askToSave(QWidget* window, const QString& name);

}  // namespace app
