#include "app/compare/compare_menu.h"

#include <QFileDialog>
#include <QMenu>

#include "app/compare/buffer_compare.h"
#include "app/document/renderer_check.h"
#include "app/frames/derived_buffers.h"

namespace app {

namespace {

void chooseFile(BufferCompare& compare) {
    const QString file =
        QFileDialog::getOpenFileName(compare.bar()->window(), BufferCompare::tr("Compare with a file"), QString(),
                                     BufferCompare::tr("Pictures and arrays (*.png *.npy *.exr);;All files (*)"));
    if (!file.isEmpty()) compare.compareWith(OtherSource{.kind = OtherSource::Kind::File, .file = file});
}

}  // namespace

void fillCompareMenu(QMenu& menu, BufferCompare& compare, Document& document, const pipeline::BufferName& shown) {
    menu.clear();
    menu.setToolTipsVisible(true);
    if (!document.frames().shown()) return;
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
    for (const OtherChoice& choice : otherChoices(
             *document.frames().shown(), shown, bool(document.history().sceneBefore()), document.derived().recipe())) {
        QAction* action = menuOf(choice.group)->addAction(choice.text, &compare, [&compare, source = choice.source] {
            compare.compareWith(source);
            emit compare.chosen();
        });
        action->setCheckable(true);
        action->setChecked(compare.source() == choice.source);
        // Another setting, buffer or stage may be what a page asks for.
        const bool isHidden = document.hidden().count() != 0 && choice.source.kind != OtherSource::Kind::Before;
        const QString whyNot = isHidden ? BufferCompare::tr("After your answer.") : choice.whyNot;
        action->setEnabled(whyNot.isEmpty());
        action->setToolTip(whyNot);
    }
    QAction* mine = menu.addAction(BufferCompare::tr("My renderer"), &compare, [&compare] {
        compare.compareWith(OtherSource{.kind = OtherSource::Kind::Mine});
        emit compare.chosen();
    });
    mine->setCheckable(true);
    mine->setChecked(compare.isMine());
    mine->setEnabled(document.renderer().isOpen());
    if (!mine->isEnabled()) mine->setToolTip(document.renderer().whyNo(shown));
    menu.addAction(BufferCompare::tr("A file…"), &compare, [&compare] { chooseFile(compare); });
    menu.addSeparator();
    QAction* nothing =
        menu.addAction(BufferCompare::tr("Nothing"), &compare, [&compare] { compare.compareWith(std::nullopt); });
    nothing->setEnabled(compare.source().has_value());
    if (!compare.source()) nothing->setToolTip(BufferCompare::tr("Nothing is compared."));
}

}  // namespace app
