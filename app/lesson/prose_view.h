#pragma once
#include <QTextBrowser>
#include <filesystem>

namespace app {

// Markdown at its full height, in the theme's fonts: it grows with its text and leaves scrolling to
// what it stands in. A letter N, L, V, R or H in bold italics is that vector, in its colour; "I_b" and "n^2"
// outside code get a subscript and a superscript. The text is a stranger's: HTML in it is shown as it was typed, pictures
// come from the lesson's folder (lessons/pages/picture.h), a click leads to the web alone.
class ProseView : public QTextBrowser {
    Q_OBJECT
public:
    enum class Tone { Plain, Heading, Question, Right, NotYet };

    explicit ProseView(QWidget* parent = nullptr);

    void setPictureFolder(const std::filesystem::path& folder) { m_folder = folder; }  // for the next setProse
    void setProse(const QString& markdown, Tone tone = Tone::Plain);

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void typeset();
    void placePictures();
    void fitPictures();
    void dropForeignLinks();
    void markVectors();
    void raiseScripts();
    void fitHeight();

    std::filesystem::path m_folder;
    QString m_markdown;
    Tone m_tone = Tone::Plain;
};

// The words of Markdown without what it is marked up with.
QString plainText(const QString& markdown);

}  // namespace app
