package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * What a new state has to do with the device while it lasts, as drawn: keywords beside the state's name, {@code «device
 * StopUp» Gap} or {@code «sends speed, stop» Storm}. It holds for the states inside, too, unless one of them has a device
 * state of its own.
 *
 * <p>Threading: immutable.
 *
 * @param device the state of the original model in which the device must be, by name or path; empty for any
 * @param sends the events that the state's function may send to the device, in order
 * @since 0.1
 */
public record DeviceUse(String device, List<String> sends) {
    /** The device may be anywhere, and nothing is sent. */
    public static final DeviceUse NONE = new DeviceUse("", List.of());

    static final String DEVICE = "device";
    static final String SENDS = "sends";

    private static final Pattern PART = Pattern.compile(
            "(" + DEVICE + "|" + SENDS + ")\\s+(\\S.*?)\\s*(?:,\\s*(?=(?:" + DEVICE + "|" + SENDS + ")\\s)|$)",
            Pattern.DOTALL);

    public DeviceUse {
        sends = List.copyOf(sends);
    }

    /**
     * What a text without guillemets says, such as the invariant {@code device StopUp}; nothing if it says something
     * else.
     */
    public static Optional<DeviceUse> parse(String text) {
        Matcher part = PART.matcher(text.strip());
        String device = "";
        List<String> sends = new ArrayList<>();
        int end = 0;
        while (part.find() && part.start() == end) {
            String value = part.group(2);
            if (part.group(1).equals(SENDS)) {
                Arrays.stream(value.split(",", -1)).map(String::strip).forEach(sends::add);
            } else if (device.isEmpty()) {
                device = value;
            } else {
                return Optional.empty();
            }
            end = part.end();
        }
        boolean whole = end > 0 && end == text.strip().length() && !sends.contains("");
        return whole ? Optional.of(new DeviceUse(device, sends)) : Optional.empty();
    }

    /**
     * What is wrong with the invariant of a state; null if it is not meant as a keyword.
     *
     * @param what the state, for messages
     * @param text that {@link #parse} does not understand
     */
    public static @Nullable Problem misspelt(Place place, String what, String text) {
        return Keywords.misspelt(place, what, text);
    }

    /** The same of a state of a flat machine. */
    public static DeviceUse of(StateMachine machine, State state) {
        String device = machine.deviceState(state);
        List<String> sends = machine.sends(state).stream().map(Event::name).toList();
        return device == null && sends.isEmpty() ? NONE : new DeviceUse(device == null ? "" : device, sends);
    }

    /** What the keywords beside a state's name say. */
    static DeviceUse of(String drawn) {
        DeviceUse all = NONE;
        for (String part : understood(drawn)) {
            DeviceUse more = parse(part).orElseThrow();
            all = all.and(more).orElseThrow();
        }
        return all;
    }

    /** A state's name without the keywords that have been understood. */
    static String unmarked(String drawn) {
        if (!Keywords.isPossible(drawn)) {
            return drawn;
        }
        List<String> left = new ArrayList<>(understood(drawn));
        String name = Keywords.GROUP.matcher(drawn).replaceAll(group -> {
            boolean known = left.remove(group.group(1));
            return known ? " " : Matcher.quoteReplacement(group.group());
        });
        return name.strip();
    }

    /** The texts of the keywords that say something together; a second device state stays. */
    private static List<String> understood(String drawn) {
        if (!Keywords.isPossible(drawn)) {
            return List.of();
        }
        List<String> understood = new ArrayList<>();
        DeviceUse all = NONE;
        Matcher group = Keywords.GROUP.matcher(drawn);
        while (group.find()) {
            Optional<DeviceUse> more = parse(group.group(1)).flatMap(all::and);
            if (more.isPresent()) {
                understood.add(group.group(1));
                all = more.get();
            }
        }
        return understood;
    }

    /** Both; nothing if they name different device states. */
    public Optional<DeviceUse> and(DeviceUse other) {
        if (!device.isEmpty() && !other.device.isEmpty() && !device.equals(other.device)) {
            return Optional.empty();
        }
        Set<String> all = new LinkedHashSet<>(sends);
        all.addAll(other.sends);
        return Optional.of(new DeviceUse(device.isEmpty() ? other.device : device, List.copyOf(all)));
    }

    /** Whether it says nothing. */
    public boolean isNone() {
        return device.isEmpty() && sends.isEmpty();
    }

    /** The keywords, such as {@code «device StopUp»}; empty if it says nothing. */
    public String keywords() {
        String where = device.isEmpty() ? "" : "«" + DEVICE + " " + device + "»";
        String what = sends.isEmpty() ? "" : "«" + SENDS + " " + String.join(", ", sends) + "»";
        return where.isEmpty() || what.isEmpty() ? where + what : where + " " + what;
    }

    /** A state's name, preceded by the keywords. */
    public String mark(String name) {
        return isNone() ? name : keywords() + " " + name;
    }
}
