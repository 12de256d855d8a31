#pragma once
#include <QObject>

namespace app {

class Actions;
class ContractList;
class Document;
class PixelField;
class StageStrip;
class ViewArea;

// Goes to a stage, a pixel and a channel, and lists the contracts of the stage on show.
class StageActions : public QObject {
    Q_OBJECT
public:
    StageActions(QWidget& window, Actions& actions, Document& document, ViewArea& views, StageStrip& strip);

private:
    void addStages(Actions& actions);
    void addPixels(Actions& actions);
    void addChannels(Actions& actions);
    void goToPixel();
    void showContracts();

    QWidget& m_window;
    Document& m_document;
    ViewArea& m_views;
    StageStrip& m_strip;
    PixelField* m_pixelField;
    ContractList* m_contracts = nullptr;  // made when first asked for
};

}  // namespace app
