package org.evoloop.mqtt.home;

import java.time.Instant;
import java.time.LocalTime;
import java.time.format.DateTimeParseException;
import java.time.temporal.ChronoUnit;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Something that its owner sets in Home Assistant while a converter runs, such as the begin of quiet hours. The broker
 * retains what was set, so that it outlasts a restart of the converter, until the converter is started with another
 * value of its own.
 *
 * <pre>{@code
 * home.setting(HomeSetting.time("Quiet from", quiet::from, quiet::begin));
 * }</pre>
 *
 * <p>Threading: immutable; its functions are called on threads of {@link HomeAssistant}, one at a time.
 *
 * @since 0.1
 */
public final class HomeSetting {
    private static final Map<String, Boolean> ON_OFF = Map.of("ON", true, "OFF", false);

    private final String name;
    private final String platform;
    private final Supplier<@Nullable String> shown;
    private final @Nullable Consumer<String> set;
    private final Supplier<String> kept;
    private final Consumer<String> restored;
    private final String icon;

    private HomeSetting(
            String name,
            String platform,
            Supplier<@Nullable String> shown,
            @Nullable Consumer<String> set,
            Supplier<String> kept,
            Consumer<String> restored,
            String icon) {
        this.name = name;
        this.platform = platform;
        this.shown = shown;
        this.set = set;
        this.kept = kept;
        this.restored = restored;
        this.icon = icon;
    }

    private HomeSetting(String name, String platform, Supplier<String> shown, Consumer<String> set) {
        this(name, platform, shown, set, shown, set, "");
    }

    /**
     * A switch.
     *
     * @param name its name for people
     * @param set an exception's message is shown as the reason why that was refused
     */
    public static HomeSetting onOff(String name, BooleanSupplier now, Consumer<Boolean> set) {
        return new HomeSetting(name, "switch", () -> now.getAsBoolean() ? "ON" : "OFF", wanted -> {
            Boolean on = ON_OFF.get(wanted);
            if (on == null) {
                throw new IllegalArgumentException(name + " is ON or OFF, not " + wanted);
            }
            set.accept(on);
        });
    }

    /**
     * A time of day.
     *
     * @param set as of {@link #onOff}
     */
    public static HomeSetting time(String name, Supplier<LocalTime> now, Consumer<LocalTime> set) {
        return new HomeSetting(
                name,
                "time",
                () -> now.get().truncatedTo(ChronoUnit.SECONDS).toString(),
                wanted -> set.accept(timeOf(name, wanted)));
    }

    private static LocalTime timeOf(String name, String text) {
        try {
            return LocalTime.parse(text);
        } catch (DateTimeParseException wrong) {
            throw new IllegalArgumentException(name + " is a time of day such as 22:00, not " + text, wrong);
        }
    }

    /**
     * A text.
     *
     * @param set as of {@link #onOff}
     */
    public static HomeSetting text(String name, Supplier<String> now, Consumer<String> set) {
        return new HomeSetting(name, "text", now, set);
    }

    /** A time that is only shown, such as that of the next start. */
    public static HomeSetting moment(String name, Supplier<Optional<Instant>> now) {
        return new HomeSetting(
                name, "sensor", () -> now.get().map(Instant::toString).orElse(null), null, () -> "", nothing -> {}, "");
    }

    /**
     * Keeps something else than what is shown.
     *
     * @param other what the broker retains
     * @param restore receives it after a restart
     */
    public HomeSetting keptAs(Supplier<String> other, Consumer<String> restore) {
        return new HomeSetting(name, platform, shown, set, other, restore, icon);
    }

    /**
     * Has another icon: on a narrow card, an owner sees little of a name.
     *
     * @param other as Home Assistant calls it, such as {@code mdi:weather-night}
     */
    public HomeSetting icon(String other) {
        return new HomeSetting(name, platform, shown, set, kept, restored, other);
    }

    String name() {
        return name;
    }

    /** Empty for the usual one. */
    String icon() {
        return icon;
    }

    /** Its name in topics and JSON. */
    String key() {
        return HomeDiscovery.key(name);
    }

    /** What Home Assistant calls this kind. */
    String platform() {
        return platform;
    }

    /** What it shows; null if nothing. */
    @Nullable
    String shown() {
        return shown.get();
    }

    /** Whether it can be set. */
    boolean isSet() {
        return set != null;
    }

    /** @throws RuntimeException if that is refused; its message says why */
    void set(String wanted) {
        if (set != null) {
            set.accept(wanted);
        }
    }

    String kept() {
        return kept.get();
    }

    void restore(String value) {
        restored.accept(value);
    }
}
