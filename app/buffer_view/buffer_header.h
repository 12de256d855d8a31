#pragma once
#include <QWidget>

#include "app/widgets/buffer_chooser.h"

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace app {

class ElidedLabel;

// Above a buffer: its name, what is shown in words, its channels, and the buttons of the view.
class BufferHeader : public QWidget {
    Q_OBJECT
public:
    explicit BufferHeader(const Document& document, QWidget* parent = nullptr);

    void show(const pipeline::BufferName& name, lessons::ShownChannel channel);
    void setZoom(double zoom);  // screen pixels per picture pixel; 0: there is no picture
    void setOverlays(bool on);  // as the two buttons show it
    void setLoupe(bool on);
    void setFlipped(bool flipped);
    BufferChooser* chooser() { return m_chooser; }
    void openCompareMenu();
    void openMoreMenu(const QPoint& at);  // of the screen
    QMenu* menu() { return m_menu; }      // of the last button, for the entries of features and of the window

signals:
    void channelChosen(lessons::ShownChannel channel);
    void fitChosen();
    void originalChosen();               // one to one
    void overlayMenuOpens(QMenu* menu);  // it is to be filled
    void loupeToggled(bool on);
    void compareMenuOpens(QMenu* menu);  // it is to be filled

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* button(const QString& iconName, const QString& name, const QString& tip);
    void arrange();
    void showCaption();

    BufferChooser* m_chooser;
    ElidedLabel* m_caption;
    QToolButton *m_channels[3], *m_luminance, *m_fit, *m_original, *m_overlays, *m_loupe, *m_compare, *m_more;
    QLabel* m_zoom;
    QMenu* m_menu;
    QString m_words;  // of the caption, with row 0 on top
    bool m_isFlipped = false;
    int m_channelCount = 1;
    bool m_hasLuminance = false;
};

}  // namespace app
