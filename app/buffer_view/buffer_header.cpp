#include "app/buffer_view/buffer_header.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "app/canvas/shown_buffer.h"
#include "app/look/icons.h"
#include "app/look/luminance.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

// Rather no word than a piece of one.
class Caption : public ElidedLabel {
public:
    using ElidedLabel::ElidedLabel;

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(contentsRect(), int(alignment()), wholePhrases(text(), fontMetrics(), contentsRect().width()));
    }
};

}  // namespace

BufferHeader::BufferHeader(const Document& document, QWidget* parent)
    : QWidget(parent), m_chooser(new BufferChooser(document, this)), m_caption(new Caption(this)) {
    auto* row = spaced(new QHBoxLayout(this), {6, 0, 6, 0}, 2);
    row->addWidget(m_chooser);
    row->addWidget(m_caption, 1);
    m_caption->setProperty("tone", "2");
    for (int c = 0; c < 3; ++c) {
        m_channels[c] = new QToolButton(this);
        m_channels[c]->setCheckable(true);
        row->addWidget(m_channels[c]);
        connect(m_channels[c], &QToolButton::clicked, this,
                [this, c](bool on) { emit channelChosen(on ? lessons::ShownChannel(c) : lessons::ShownChannel::All); });
    }
    m_luminance = new QToolButton(this);
    m_luminance->setObjectName("luminance");
    m_luminance->setText("L");
    m_luminance->setCheckable(true);
    m_luminance->setAccessibleName(tr("Luminance"));
    m_luminance->setToolTip(
        tr("Show the luminance (L), 0.2126 r + 0.7152 g + 0.0722 b of the light (Rec. 709); C shows the colours"));
    row->addWidget(m_luminance);
    connect(m_luminance, &QToolButton::clicked, this, [this](bool on) {
        emit channelChosen(on ? lessons::ShownChannel::Luminance : lessons::ShownChannel::All);
    });
    m_fit = button("fit", tr("Fit"), tr("Show what is drawn; again for all of the picture (F)"));
    m_original = new QToolButton(this);
    m_original->setText("1:1");
    m_original->setAccessibleName(tr("One to one"));
    m_original->setToolTip(tr("A pixel of the screen each (Ctrl+0)"));
    m_zoom = new QLabel(this);
    m_zoom->setAccessibleName(tr("Zoom"));
    m_loupe = button("loupe", tr("Loupe"), tr("Enlarge the pixels under the cursor (Z)"));
    m_loupe->setCheckable(true);
    m_overlays = button("layers", tr("Overlays"), tr("Lay edges, verdicts, depth tests and more over the picture"));
    m_overlays->setCheckable(true);
    auto* overlays = new QMenu(m_overlays);
    connect(overlays, &QMenu::aboutToShow, this, [this, overlays] { emit overlayMenuOpens(overlays); });
    m_overlays->setMenu(overlays);
    m_overlays->setPopupMode(QToolButton::InstantPopup);
    m_compare = button("compare", tr("Compare with…"), tr("Compare with another buffer, stage or pipeline"));
    auto* others = new QMenu(m_compare);
    connect(others, &QMenu::aboutToShow, this, [this, others] { emit compareMenuOpens(others); });
    m_compare->setMenu(others);
    m_compare->setPopupMode(QToolButton::InstantPopup);
    m_more = button("more", tr("More"), tr("Copy, pins, statistics, which way up, other views"));
    m_menu = new QMenu(m_more);
    m_menu->setToolTipsVisible(true);
    m_more->setMenu(m_menu);
    m_more->setPopupMode(QToolButton::InstantPopup);
    for (QWidget* part :
         {static_cast<QWidget*>(m_fit), static_cast<QWidget*>(m_original), static_cast<QWidget*>(m_zoom),
          static_cast<QWidget*>(m_loupe), static_cast<QWidget*>(m_overlays), static_cast<QWidget*>(m_compare),
          static_cast<QWidget*>(m_more)})
        row->addWidget(part);

    connect(m_fit, &QToolButton::clicked, this, &BufferHeader::fitChosen);
    connect(m_original, &QToolButton::clicked, this, &BufferHeader::originalChosen);
    connect(m_loupe, &QToolButton::clicked, this, &BufferHeader::loupeToggled);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        setFixedHeight(theme.px(32));
        m_caption->setFont(theme.text(12));
        m_zoom->setFont(theme.mono(12));
        m_zoom->setMinimumWidth(m_zoom->fontMetrics().horizontalAdvance("0.33×"));
        m_zoom->setAlignment(Qt::AlignCenter);
        m_original->setFont(theme.text(12, 500));
        for (QToolButton* channel : {m_channels[0], m_channels[1], m_channels[2], m_luminance}) {
            QFont italic = theme.formula(14);
            italic.setItalic(true);
            channel->setFont(italic);
        }
        for (QToolButton* b : findChildren<QToolButton*>())
            if (b != m_chooser) b->setIconSize(QSize(1, 1) * theme.px(16));
    });
}

QToolButton* BufferHeader::button(const QString& iconName, const QString& name, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setIcon(icon(iconName));
    made->setAccessibleName(name);
    made->setToolTip(tip);
    return made;
}

void BufferHeader::show(const pipeline::BufferName& name, lessons::ShownChannel channel) {
    const pipeline::BufferInfo& info = bufferInfo(name.id);
    m_chooser->setName(name);
    m_words = captionOf(info, channel);
    showCaption();
    const QStringList names = channelNames(info);
    m_channelCount = info.channels;
    for (int c = 0; c < names.size(); ++c) {
        m_channels[c]->setText(names[c]);
        m_channels[c]->setChecked(lessons::ShownChannel(c) == channel);
        m_channels[c]->setAccessibleName(tr("Channel %1 alone").arg(names[c]));
        m_channels[c]->setToolTip(tr("Show %1 alone (%2); C shows all").arg(names[c]).arg(QString("RGB")[c]));
    }
    m_hasLuminance = hasLuminance(info);
    m_luminance->setChecked(channel == lessons::ShownChannel::Luminance);
    arrange();
}

void BufferHeader::setZoom(double zoom) {
    m_zoom->setText(zoom > 0 ? number(zoom, zoom >= 2 || zoom == 1 ? 0 : 2) + "×" : QString());
    m_zoom->setAccessibleName(tr("Zoom %1").arg(m_zoom->text()));
}

void BufferHeader::setFlipped(bool flipped) {
    m_isFlipped = flipped;
    showCaption();
}

void BufferHeader::showCaption() {
    QString words = m_words;
    m_caption->setText(m_isFlipped ? words.replace("row 0 on top", tr("row 0 at the bottom")) : words);
}

void BufferHeader::setOverlays(bool on) { m_overlays->setChecked(on); }
void BufferHeader::setLoupe(bool on) { m_loupe->setChecked(on); }

// What a narrow view can do without, by key too: the channels first.
void BufferHeader::arrange() {
    const int width = this->width(), unit = Theme::current().px(10);
    for (QToolButton* channel : m_channels) channel->setVisible(m_channelCount == 3 && width > 42 * unit);
    m_luminance->setVisible(m_hasLuminance && width > 46 * unit);
    m_original->setVisible(width > 32 * unit);
    m_loupe->setVisible(width > 28 * unit);
}

void BufferHeader::openCompareMenu() { m_compare->showMenu(); }

void BufferHeader::openMoreMenu(const QPoint& at) { m_more->menu()->popup(at); }

void BufferHeader::resizeEvent(QResizeEvent*) { arrange(); }

}  // namespace app
