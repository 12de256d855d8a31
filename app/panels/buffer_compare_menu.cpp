// What a BufferCompare offers and says; what it does stands in buffer_compare.cpp.
#include <QFileDialog>
#include <QMenu>

#include "app/core/derived_buffers.h"
#include "app/core/numbers.h"
#include "app/core/text.h"
#include "app/panels/buffer_compare.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferName;

namespace {

QString placeText(const AnyBuffer& buffer, std::size_t element) {
    if (standsOnShapes(*buffer.info)) return QString::number(element);
    return QString("%1, %2").arg(element % buffer.columns()).arg(element / buffer.columns());
}

}  // namespace

QString findingText(const pipeline::BufferDifference& found) {
    static const QStringList things{"vertices", "polygons", "pixels", "texels"};
    const AnyBuffer& values = found.values;
    const QString thing = things[int(values.info->domain)];
    if (found.differing == 0) return QString("All %1 are the same.").arg(thing);
    const auto all = qint64(found.compared + found.oneSided);
    QString text = QString("%1 of %2 %3 differ").arg(count(qint64(found.differing)), count(all), thing);
    if (found.largest > 0)
        text += QString(", most by %1 at %2").arg(valueText(values, found.largest), placeText(values, *found.worst));
    if (found.oneSided > 0) text += QString(", %1 have a value on one side only").arg(count(qint64(found.oneSided)));
    return text;
}

void BufferCompare::fillMenu(QMenu& menu, const BufferName& shown) {
    menu.clear();
    menu.setToolTipsVisible(true);
    if (!m_document.frame()) return;
    QHash<QString, QMenu*> menus;
    const auto menuOf = [&](const QString& path) {
        QMenu* place = &menu;
        QString whole;
        for (const QString& part : path.split('/', Qt::SkipEmptyParts)) {
            whole += '/' + part;
            QMenu*& sub = menus[whole];
            if (!sub) {
                sub = place->addMenu(part);
                sub->setToolTipsVisible(true);
            }
            place = sub;
        }
        return place;
    };
    for (const OtherChoice& choice :
         otherChoices(*m_document.frame(), shown, bool(m_document.sceneBefore()), m_document.derived().recipe())) {
        QAction* action =
            menuOf(choice.group)->addAction(choice.text, this, [this, source = choice.source] { compareWith(source); });
        action->setCheckable(true);
        action->setChecked(m_source == choice.source);
        action->setEnabled(choice.whyNot.isEmpty());
        action->setToolTip(choice.whyNot);
    }
    menu.addAction(tr("A file…"), this, &BufferCompare::chooseFile);
    menu.addSeparator();
    QAction* nothing = menu.addAction(tr("Nothing"), this, [this] { compareWith(std::nullopt); });
    nothing->setEnabled(m_source.has_value());
    if (!m_source) nothing->setToolTip(tr("Nothing is compared."));
}

void BufferCompare::chooseFile() {
    const QString file = QFileDialog::getOpenFileName(m_bar->window(), tr("Compare with a file"), QString(),
                                                      tr("Pictures and arrays (*.png *.npy *.exr);;All files (*)"));
    if (!file.isEmpty()) compareWith(OtherSource{.kind = OtherSource::Kind::File, .file = file});
}

}  // namespace app
