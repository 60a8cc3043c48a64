package org.evoloop.mqtt.home;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * An entity of Home Assistant that shows the new model's states and obeys commands, such as a cover. What maps by name
 * need not be said: a state {@code Closing} is shown as {@code closing}.
 *
 * <pre>{@code
 * home.entity(HomeEntity.of(HomeKind.COVER).show("Gap", "stopped"));
 * }</pre>
 *
 * <p>Lifecycle: made and completed before {@link HomeAssistant#open}.
 *
 * <p>Threading: completed by one thread; {@link Hooks} are called on a thread of {@link HomeAssistant}.
 *
 * @since 0.1
 */
public final class HomeEntity {
    private static final Hooks NONE = new Hooks() {};

    private final HomeKind kind;
    private final Map<String, String> shown = new LinkedHashMap<>();
    private final Map<String, Set<String>> modes = new LinkedHashMap<>();
    private final Map<String, String> goals = new LinkedHashMap<>();
    private final Map<String, Set<String>> neverIn = new LinkedHashMap<>();
    private final Set<String> mayPass = new LinkedHashSet<>();
    private final Set<String> presses = new LinkedHashSet<>();
    private String name = "";
    private String reading = "";
    private String deviceClass = "";
    private Hooks hooks = NONE;

    /** What an entity knows beyond the models. */
    public interface Hooks {
        /**
         * What it shows now.
         *
         * @param byState what it shows by the new model's state; null if nothing
         */
        default @Nullable String shown(ConverterStatus now, @Nullable String byState) {
            return byState;
        }

        /** What a state shows whose name does not say it; null if that is not known. */
        default @Nullable String shown(State state, ModelPair models) {
            return null;
        }

        /** The states of the new model to which a command leads; null for those that are shown as it means. */
        default @Nullable List<State> goals(String command, StateMachine evolved) {
            return null;
        }

        /**
         * Whether this command is to be carried out by the models. If not, nothing happens, or what this method does.
         *
         * @throws Exception if the command is refused: the message is shown as the reason
         */
        default boolean begins(String command, ConverterStatus now) throws Exception {
            return true;
        }

        /** Further commands, which {@link #begins} carries out. */
        default Set<String> commands() {
            return Set.of();
        }
    }

    private HomeEntity(HomeKind kind) {
        this.kind = kind;
    }

    /** An entity of this kind, called as its device. */
    public static HomeEntity of(HomeKind kind) {
        return new HomeEntity(kind);
    }

    /** Its name beside the device's. */
    public HomeEntity name(String its) {
        name = its;
        return this;
    }

    /** Shows a state of the new model as one of {@link HomeKind#shown}. */
    public HomeEntity show(String state, String as) {
        shown.put(state, as);
        return this;
    }

    /** A {@linkplain HomeKind#modeWord mode} that is this state of the new model, or another one that was given before. */
    public HomeEntity mode(String mode, String state) {
        modes.computeIfAbsent(mode, any -> new LinkedHashSet<>()).add(state);
        return this;
    }

    /** A command leads to this state of the new model, and to no other. */
    public HomeEntity command(String command, String state) {
        goals.put(command, state);
        return this;
    }

    /** Commands press this event; without any, they press all that a controller may raise. */
    public HomeEntity presses(String event) {
        presses.add(event);
        return this;
    }

    /** Every command may pass this state, whatever it shows. */
    public HomeEntity mayPass(String state) {
        mayPass.add(state);
        return this;
    }

    /** A command is refused in this state. */
    public HomeEntity neverIn(String state, String command) {
        neverIn.computeIfAbsent(state, any -> new LinkedHashSet<>()).add(command);
        return this;
    }

    /** The reading that is a cover's position in percent, or a climate's present temperature. */
    public HomeEntity reading(String its) {
        reading = its;
        return this;
    }

    /** What Home Assistant calls its device class, such as {@code shutter}. */
    public HomeEntity deviceClass(String its) {
        deviceClass = its;
        return this;
    }

    /** What it knows beyond the models. */
    public HomeEntity hooks(Hooks its) {
        hooks = its;
        return this;
    }

    /** Its kind. */
    public HomeKind kind() {
        return kind;
    }

    /** Its name, {@code cover} or {@code cover Name}, for messages. */
    @Override
    public String toString() {
        return name.isEmpty() ? kind.word() : kind.word() + " " + name;
    }

    String name() {
        return name;
    }

    /** Its name in topics and JSON, which no other entity of the converter has. */
    public String key() {
        return name.isEmpty() ? kind.word() : kind.word() + "_" + HomeDiscovery.key(name);
    }

    Map<String, String> shownStates() {
        return shown;
    }

    /** The names of the commands that it can be given, with those of its modes. */
    public List<String> commandNames() {
        List<String> names = new ArrayList<>(kind.commands());
        if (kind.hasModes() && kind != HomeKind.EVENT) {
            modes.keySet().forEach(mode -> names.add(kind.modeWord() + " " + mode));
            names.add(kind.modeWord() + " " + HomeTable.NO_MODE);
        }
        return names;
    }

    /** The names of its modes. */
    public Set<String> modeNames() {
        return modes.keySet();
    }

    Map<String, Set<String>> modes() {
        return modes;
    }

    Map<String, String> goals() {
        return goals;
    }

    Set<String> pressed() {
        return presses;
    }

    Set<String> passed() {
        return mayPass;
    }

    Set<String> neverIn(String state) {
        return neverIn.getOrDefault(state, Set.of());
    }

    String reading() {
        return reading;
    }

    String deviceClass() {
        return deviceClass;
    }

    Hooks hooks() {
        return hooks;
    }
}
