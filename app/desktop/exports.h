#pragma once
#include <QObject>

namespace app {

class Actions;
class Document;
class ExportDialog;
class ShownState;
class ViewArea;

// Exports the frame: buffers, figures, pictures for slides, step films.
class Exports : public QObject {
    Q_OBJECT
public:
    Exports(QWidget& window, Actions& actions, Document& document, ViewArea& views, const ShownState& shown);

private:
    void exportBuffers();
    void exportActive();
    void exportFigure();
    void exportSlide();
    void exportFilm();
    ExportDialog* makeDialog();

    QWidget& m_window;
    Document& m_document;
    ViewArea& m_views;
    const ShownState& m_shown;
};

// Why the frame's values cannot be written or listed yet; empty if they can.
QString whyNoValues(const Document& document);

}  // namespace app
