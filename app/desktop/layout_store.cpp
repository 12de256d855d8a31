#include "app/desktop/layout_store.h"

#include <QGuiApplication>
#include <QScreen>
#include <QSettings>

#include "app/core/theme.h"

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

constexpr const char* kThemeNames[]{"dark", "light", "projector"};

}  // namespace

void saveLayout(const QMainWindow& window) {
    QSettings().setValue(layoutKey(window), window.saveState(kLayoutVersion));
}

bool restoreLayout(QMainWindow& window) {
    const QByteArray state = QSettings().value(layoutKey(window)).toByteArray();
    return !state.isEmpty() && window.restoreState(state, kLayoutVersion);
}

void forgetLayout(const QMainWindow& window) { QSettings().remove(layoutKey(window)); }

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
    settings.setValue("sizes", layout.sizes);
    settings.setValue("thumbnails", layout.thumbnails);
}

std::optional<KeptLayout> keptLayout(const QString& name) {
    QSettings settings;
    settings.beginGroup(keyOf(name));
    if (!settings.contains("arrangement")) return {};
    return KeptLayout{settings.value("panels").toByteArray(), settings.value("arrangement").toString(),
                      settings.value("sizes").toByteArray(), settings.value("thumbnails").toBool()};
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

}  // namespace app
