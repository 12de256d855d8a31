#pragma once
#include <QDialog>
#include <string>

namespace app {

// A text file, at one of its lines. Lines and columns count from 1.
class SourceView : public QDialog {
    Q_OBJECT
public:
    SourceView(const QString& file, const QString& text, int line, int column, QWidget* parent = nullptr);
};

// The file that an object's polygons come from, as the scene names it from its own file.
QString sourceFile(const std::string& sceneFile, const std::string& meshFile);
// Opens a view that closes itself; false where the file cannot be read, or is too large for one.
bool showSource(const QString& file, int line, int column, QWidget* parent);

}  // namespace app
