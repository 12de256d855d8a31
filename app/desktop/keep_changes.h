#pragma once
#include <QWidget>

namespace app {

enum class KeepChanges { Save, Discard, Cancel };
// "Save the changes to pyramid.scene?", over `window`; Esc cancels.
KeepChanges askToKeep(QWidget* window, const QString& name);

}  // namespace app
