#include "app/lesson/lesson_results_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/lesson/lesson_run.h"
#include "app/lesson/question_card.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/widgets/on_screen.h"
#include "lessons/questions/misconceptions.h"

namespace app {

namespace {

QStringList rowOf(const lessons::Page& page, const lessons::Progress& progress) {
    QStringList tries, mistakes;
    for (const lessons::Try& one : progress.tries) {
        tries << toQString(one.given);
        if (const auto* known = lessons::findMisconception(one.mistake)) mistakes << toQString(known->name);
    }
    const QString points = progress.outcome == lessons::Progress::Outcome::Open
                               ? LessonResultsDialog::tr("open")
                               : LessonResultsDialog::tr("%1 of %2")
                                     .arg(pointsText(pointsOf(page, progress)), pointsText(fullPoints(page)));
    return {toQString(page.heading), points, QString::number(progress.hints), tries.join(QStringLiteral("; ")),
            mistakes.join(QStringLiteral("; "))};
}

}  // namespace

void LessonResultsDialog::showResults(LessonShelf& shelf, const LessonResults& results, QWidget* parent) {
    auto* dialog = new LessonResultsDialog(shelf, results, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

LessonResultsDialog::LessonResultsDialog(LessonShelf& shelf, const LessonResults& results, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("My results"));
    setObjectName("lessonResults");
    auto* table = new QTreeWidget(this);
    table->setObjectName("resultsTable");
    table->setAccessibleName(tr("My results"));
    table->setHeaderLabels({tr("Page"), tr("Points"), tr("Hints"), tr("Tried"), tr("Known mistakes")});
    for (int i = 0; i < shelf.rowCount(); ++i) {
        const QString name = shelf.index(i).data(LessonShelf::NameRole).toString();
        if (!results.all().lessons().contains(name.toStdString())) continue;
        const lessons::Lesson* const lesson = shelf.find(name);
        QList<QTreeWidgetItem*> rows;
        for (const lessons::Page& page : lesson ? lesson->pages : std::vector<lessons::Page>()) {
            const lessons::Progress progress = results.progress(name, toQString(page.heading));
            if (page.question && progress != lessons::Progress()) rows << new QTreeWidgetItem(rowOf(page, progress));
        }
        if (rows.isEmpty()) continue;
        auto* top = new QTreeWidgetItem(table, {toQString(lesson->title)});
        top->addChildren(rows);
        top->setExpanded(true);
    }
    table->header()->resizeSections(QHeaderView::ResizeToContents);
    auto* words = new QLabel(tr("They are kept in %1 and nowhere else.").arg(LessonResults::file()), this);
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(table, 1);
    column->addWidget(words);
    column->addWidget(buttons);
    resize(onScreen(*this, Theme::current().px(760), Theme::current().px(420)));
}

}  // namespace app
