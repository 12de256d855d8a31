#pragma once
#include <QWidget>

namespace app {

enum class KeepChanges { Keep, Drop, GoBack };
// "Keep the changes to pyramid.scene?", over `window`; Esc goes back.
KeepChanges askToKeep(QWidget* window, const QString& name);

}  // namespace app
