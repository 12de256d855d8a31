#include "app/docks/layout_store.h"

#include <QDataStream>
#include <QGuiApplication>
#include <QIODevice>
#include <QScreen>
#include <QSettings>
#include <algorithm>

#include "app/look/number_format.h"
#include "app/look/theme.h"
#include "lessons/state/view_tree.h"

namespace app {
namespace {

QString layoutKey(const QMainWindow& window) {
    const QSize size = window.screen()->size();
    return QStringLiteral("layout/%1x%2").arg(size.width()).arg(size.height());
}

// A name may hold what separates keys.
QString keyOf(const QString& name) {
    return "layouts/" + QString::fromLatin1(name.toUtf8().toBase64(QByteArray::Base64UrlEncoding));
}

// Layouts were once kept with the sizes of the columns, then of the buffer views, 0 where there is none, beside the
// arrangement's name.
QString withSizes(const QString& arrangement, const QByteArray& sizes) {
    QList<int> columns, buffers;
    QDataStream stream(sizes);
    stream >> columns >> buffers;
    auto tree = lessons::arrangementNamed(arrangement.toStdString());
    if (sizes.isEmpty() || stream.status() != QDataStream::Ok || !tree) return arrangement;
    const auto weigh = [](lessons::ViewTree& all, const QList<int>& weights) {
        for (qsizetype i = 0; i < std::min(weights.size(), qsizetype(all.parts.size())); ++i)
            all.parts[std::size_t(i)].weight = std::max(1, weights[i]);
    };
    if (arrangement == "compare") weigh(*tree, buffers);
    if (arrangement == "one" || arrangement == "two") weigh(*tree, columns);
    if (arrangement == "two") weigh(tree->parts.front(), buffers);
    return QString::fromStdString(lessons::arrangementText(*tree));
}

constexpr const char* kThemeNames[]{"dark", "light", "projector"};
constexpr const char* kFormNames[]{"as stored", "fixed", "scientific", "hexadecimal"};

}  // namespace

void saveLayout(const QMainWindow& window) {
    QSettings().setValue(layoutKey(window), window.saveState(kLayoutVersion));
}

bool restoreLayout(QMainWindow& window) {
    const QByteArray state = QSettings().value(layoutKey(window)).toByteArray();
    return !state.isEmpty() && window.restoreState(state, kLayoutVersion);
}

void forgetLayout(const QMainWindow& window) { QSettings().remove(layoutKey(window)); }

void saveWindowPlace(const QWidget& window) { QSettings().setValue("window", window.saveGeometry()); }

bool restoreWindowPlace(QWidget& window) { return window.restoreGeometry(QSettings().value("window").toByteArray()); }

void takeFirstWindowPlace(QWidget& window) {
    const QRect screen = window.screen()->availableGeometry();
    QRect place({}, QSize(1680, 1000).boundedTo(screen.size()));
    place.moveCenter(screen.center());
    window.setGeometry(place);
}

QStringList keptLayouts() {
    QSettings settings;
    settings.beginGroup("layouts");
    QStringList names;
    for (const QString& key : settings.childGroups())
        names << QString::fromUtf8(QByteArray::fromBase64(key.toLatin1(), QByteArray::Base64UrlEncoding));
    names.sort(Qt::CaseInsensitive);
    return names;
}

void keepLayout(const QString& name, const KeptLayout& layout) {
    if (name.isEmpty()) return;
    QSettings settings;
    settings.beginGroup(keyOf(name));
    settings.setValue("panels", layout.panels);
    settings.setValue("arrangement", layout.arrangement);
    settings.setValue("thumbnails", layout.thumbnails);
}

std::optional<KeptLayout> keptLayout(const QString& name) {
    QSettings settings;
    settings.beginGroup(keyOf(name));
    if (!settings.contains("arrangement")) return {};
    const QString arrangement = settings.value("arrangement").toString();
    return KeptLayout{settings.value("panels").toByteArray(),
                      withSizes(arrangement, settings.value("sizes").toByteArray()),
                      settings.value("thumbnails").toBool()};
}

void dropLayout(const QString& name) { QSettings().remove(keyOf(name)); }

void saveTheme() {
    const Theme& theme = Theme::current();
    QSettings settings;
    settings.setValue("theme", kThemeNames[int(theme.id())]);
    settings.setValue(QStringLiteral("textScale/") + kThemeNames[int(theme.id())], theme.scale());
}

void restoreTheme() {
    Theme& theme = Theme::current();
    const QSettings settings;
    const QString wanted = settings.value("theme").toString();
    ThemeId chosen =
        QGuiApplication::palette().color(QPalette::Window).lightness() < 128 ? ThemeId::Dark : ThemeId::Light;
    for (const ThemeId id : {ThemeId::Dark, ThemeId::Light, ThemeId::Projector}) {
        if (wanted == kThemeNames[int(id)]) chosen = id;
        const QVariant scale = settings.value(QStringLiteral("textScale/") + kThemeNames[int(id)]);
        if (!scale.isValid()) continue;
        theme.set(id);
        theme.setScale(scale.toDouble());
    }
    theme.set(chosen);
}

void saveNumbers() {
    const NumberFormat& format = NumberStyle::current().format();
    QSettings settings;
    settings.setValue("numbers/form", kFormNames[int(format.form)]);
    settings.setValue("numbers/digits", format.digits);
    settings.setValue("numbers/power", format.power ? QString::number(*format.power) : QStringLiteral("never"));
}

void restoreNumbers() {
    const QSettings settings;
    NumberFormat format;
    const auto form = std::ranges::find(kFormNames, settings.value("numbers/form").toString());
    if (form != std::end(kFormNames)) format.form = NumberFormat::Form(form - std::begin(kFormNames));
    format.digits = settings.value("numbers/digits", format.digits).toInt();
    bool isNumber = false;
    const int power = settings.value("numbers/power").toInt(&isNumber);
    if (isNumber) format.power = power;
    NumberStyle::current().set(format);
}

}  // namespace app
