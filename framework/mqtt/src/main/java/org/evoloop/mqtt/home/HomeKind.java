package org.evoloop.mqtt.home;

import static java.util.Map.entry;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * A kind of entity in Home Assistant: the states that it can show, and what each of its commands means in these states
 * (Home Assistant, "MQTT Cover" and the pages of the other kinds; as of 2026.11).
 *
 * @since 0.1
 */
@SuppressWarnings("ImmutableEnumChecker") // its maps are never changed
public enum HomeKind {
    /** A shutter, a blind, a garage door. {@code moving} is a move whose direction is not known. */
    COVER(
            Map.ofEntries(
                    entry("open", "open|opened|up"),
                    entry("opening", "opening|going_up"),
                    entry("closed", "closed|close|down"),
                    entry("closing", "closing|going_down"),
                    entry("stopped", "stopped|between|half_open|partly_open"),
                    entry("moving", "moving")),
            "",
            Command.to("open", "open", "opening").past("stopped"),
            Command.to("close", "closed", "closing").past("stopped"),
            Command.to("stop", "stopped").in("opening", "closing", "moving")),
    /** A heater or an air conditioner; its states are Home Assistant's modes. */
    CLIMATE(
            Map.ofEntries(
                    entry("off", "off"),
                    entry("heat", "heat|heating"),
                    entry("cool", "cool|cooling"),
                    entry("heat_cool", "heat_cool"),
                    entry("auto", "auto|automatic"),
                    entry("dry", "dry|drying"),
                    entry("fan_only", "fan|fan_only")),
            "preset",
            Command.to("off", "off"),
            Command.to("heat", "heat"),
            Command.to("cool", "cool"),
            Command.to("heat_cool", "heat_cool"),
            Command.to("auto", "auto"),
            Command.to("dry", "dry"),
            Command.to("fan_only", "fan_only"),
            Command.to("turn_off", "off"),
            Command.to("turn_on", "heat", "cool", "heat_cool", "auto", "dry", "fan_only")),
    /** A light; its modes are effects. */
    LIGHT(Words.ON_OFF, "effect", Command.ON, Command.OFF),
    /** A switch. */
    SWITCH(Words.ON_OFF, "", Command.ON, Command.OFF),
    /** A fan; its modes are presets. */
    FAN(Words.ON_OFF, "preset", Command.ON, Command.OFF),
    /** A cleaning robot. */
    VACUUM(
            Map.ofEntries(
                    entry("cleaning", "clean|cleaning|spot|max|vacuuming"),
                    entry("docked", "docked|charging|charged"),
                    entry("paused", "pause|paused"),
                    entry("idle", "idle|on|off|asleep|stopped"),
                    entry("returning", "returning|dock|docking|homing"),
                    entry("error", "error|stuck|failed")),
            "",
            Command.to("start", "cleaning").past("idle", "paused", "docked"),
            Command.to("stop", "idle")
                    .or("paused")
                    .in("cleaning", "returning", "paused")
                    .past("paused"),
            Command.to("pause", "paused").or("idle").in("cleaning", "returning"),
            Command.to("return_to_base", "returning", "docked").past("idle", "paused"),
            Command.to("clean_spot").past("idle", "paused", "docked")),
    /** A door's lock. */
    LOCK(
            Map.ofEntries(
                    entry("locked", "locked"),
                    entry("unlocked", "unlocked"),
                    entry("locking", "locking"),
                    entry("unlocking", "unlocking"),
                    entry("open", "open|opened"),
                    entry("opening", "opening"),
                    entry("jammed", "jammed|blocked")),
            "",
            Command.to("lock", "locked", "locking"),
            Command.to("unlock", "unlocked", "unlocking"),
            Command.to("open", "open", "opening").past("unlocked", "unlocking")),
    /** A humidifier; it has modes. */
    HUMIDIFIER(Words.ON_OFF, "mode", Command.ON, Command.OFF),
    /** A valve for water or gas. */
    VALVE(
            Map.ofEntries(
                    entry("open", "open|opened"),
                    entry("opening", "opening"),
                    entry("closed", "closed|close|shut"),
                    entry("closing", "closing"),
                    entry("stopped", "stopped|between")),
            "",
            Command.to("open", "open", "opening").past("stopped"),
            Command.to("close", "closed", "closing").past("stopped"),
            Command.to("stop", "stopped").in("opening", "closing")),
    /** A choice; its modes are the options. */
    SELECT(Map.of(), "option"),
    /** A button, whose command leads to a state. */
    BUTTON(Map.of(), "", Command.to("press")),
    /** Something that happens: its modes are the types, each raised when its state is entered. */
    EVENT(Map.of(), "type");

    private final Map<String, String> words;
    private final String modeWord;
    private final Map<String, Command> commands = new LinkedHashMap<>();

    HomeKind(Map<String, String> words, String modeWord, Command... commands) {
        this.words = words;
        this.modeWord = modeWord;
        for (Command command : commands) {
            this.commands.put(command.name(), command);
        }
    }

    private static final class Words {
        private static final Map<String, String> ON_OFF = Map.of("on", "on", "off", "off");
    }

    /**
     * A command.
     *
     * @param name in topics and files
     * @param to the shown states to which it leads; the first of these sets of which the model has a state counts
     * @param in the shown states in which it does something; empty for all
     * @param past the shown states that it may pass, besides the one in which it begins and those where it ends
     */
    record Command(String name, List<Set<String>> to, Set<String> in, Set<String> past) {
        private static final Command ON = to("turn_on", "on");
        private static final Command OFF = to("turn_off", "off");

        private static Command to(String name, String... shown) {
            return new Command(name, List.of(Set.of(shown)), Set.of(), Set.of());
        }

        private Command or(String shown) {
            return new Command(name, List.of(to.get(0), Set.of(shown)), in, past);
        }

        private Command in(String... shown) {
            return new Command(name, to, Set.of(shown), past);
        }

        private Command past(String... shown) {
            return new Command(name, to, in, Set.of(shown));
        }

        /** All shown states in which it may end. */
        Set<String> ends() {
            Set<String> ends = new LinkedHashSet<>();
            to.forEach(ends::addAll);
            return ends;
        }
    }

    /** Its name in Home Assistant and in files. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** What a mode is called in Home Assistant; empty if the kind has none. */
    public String modeWord() {
        return modeWord;
    }

    /** The states that it can show; empty if what it shows are the model's states. */
    public Set<String> shown() {
        return words.keySet();
    }

    /** The names of its commands, without those of modes. */
    public Set<String> commands() {
        return commands.keySet();
    }

    /** The classes that Home Assistant knows for it, which choose its icon and words; none if it has no classes. */
    public Set<String> deviceClasses() {
        return switch (this) {
            case COVER ->
                Set.of("awning", "blind", "curtain", "damper", "door", "garage", "gate", "shade", "shutter", "window");
            case SWITCH -> Set.of("outlet", "switch");
            case HUMIDIFIER -> Set.of("dehumidifier", "humidifier");
            case VALVE -> Set.of("gas", "water");
            case BUTTON -> Set.of("identify", "restart", "update");
            case EVENT -> Set.of("button", "doorbell", "motion");
            default -> Set.of();
        };
    }

    /** Whether it shows a reading of the device. */
    public boolean hasReading() {
        return this == COVER || this == CLIMATE;
    }

    @Nullable
    Command command(String name) {
        return commands.get(name);
    }

    boolean hasModes() {
        return !modeWord.isEmpty();
    }

    boolean isOnOrOff() {
        return words == Words.ON_OFF;
    }

    /** What a state of this name shows; null if the name does not say it. */
    public @Nullable String shownBy(String state) {
        String plain = state.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_")
                .toLowerCase(Locale.ROOT)
                .replaceAll("[^a-z0-9]+", "_");
        return words.entrySet().stream()
                .filter(each -> plain.matches(each.getValue()))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(null);
    }
}
