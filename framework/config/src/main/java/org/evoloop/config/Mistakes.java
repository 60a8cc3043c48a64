package org.evoloop.config;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Collects the mistakes in a program's options, so that they can all be reported at once. A mistake names its options
 * as on the command line, {@code --port}; if the first of them that was given comes from a file, it is reported with
 * the line there.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class Mistakes {
    private static final Pattern OPTION = Pattern.compile("(?<![\\w-])--([a-z][a-z0-9-]*)");

    private final Map<String, Origin> given = new HashMap<>();
    private final Set<String> faulty = new HashSet<>();
    private final List<Mistake> found = new ArrayList<>();
    private boolean somethingIsMissing;

    private record Mistake(Origin place, String text) {}

    Mistakes() {}

    void knows(String option, Origin origin) {
        given.put(option, origin);
    }

    /** Notes that part of the input could not be read: checks across options are not reported. */
    void missSomething() {
        somethingIsMissing = true;
    }

    /** Notes that the value of this option is unusable, which has been reported. */
    void spoils(String option) {
        faulty.add(option);
    }

    /** Adds a mistake at a place. */
    void at(Origin place, String mistake) {
        found.add(new Mistake(place, Masked.urls(place.named(mistake))));
    }

    /** Adds a mistake in one option's value: nothing else about this option is reported. */
    void in(String option, Origin place, String mistake) {
        faulty.add(option);
        // A value may contain any characters.
        String line = mistake.replaceAll("\\p{Cntrl}", "?");
        at(place, line.startsWith("--") ? line : "--" + option + ": " + line);
    }

    /** Adds a mistake, unless an option that it names has one of its own. */
    public void add(String mistake) {
        List<String> named = named(mistake);
        if (!somethingIsMissing && named.stream().noneMatch(faulty::contains)) {
            at(
                    named.stream()
                            .filter(given::containsKey)
                            .findFirst()
                            .map(option -> given.getOrDefault(option, Origin.COMMAND_LINE))
                            .orElse(Origin.COMMAND_LINE),
                    mistake);
        }
    }

    /**
     * Adds the mistake for which an option's value is refused.
     *
     * @param option its name, without dashes
     * @param mistake whether a failure is the user's
     * @return the value; null if it was refused
     */
    public <T> @Nullable T tried(String option, Predicate<RuntimeException> mistake, Supplier<T> read) {
        if (faulty.contains(option)) {
            return null;
        }
        try {
            return read.get();
        } catch (RuntimeException refused) {
            if (!mistake.test(refused)) {
                throw refused;
            }
            String message = String.valueOf(refused.getMessage());
            List<String> named = named(message);
            if (named.isEmpty()) {
                at(given.getOrDefault(option, Origin.COMMAND_LINE), message);
            } else {
                add(message);
            }
            faulty.add(option);
            return null;
        }
    }

    /** Gives each mistake together with its line. */
    void forEach(BiConsumer<Integer, String> mistake) {
        found.forEach(each -> mistake.accept(each.place().line(), each.text()));
    }

    boolean isFaulty(String option) {
        return faulty.contains(option);
    }

    /**
     * Reports all mistakes.
     *
     * @throws ConfigException if there are any
     */
    public void throwIfAny() {
        if (!found.isEmpty()) {
            throw new ConfigException(found.stream()
                    .sorted(Comparator.comparingInt(each -> each.place().line()))
                    .map(each -> each.place().describe(each.text()))
                    .distinct()
                    .toList());
        }
    }

    private static List<String> named(String mistake) {
        List<String> names = new ArrayList<>();
        Matcher option = OPTION.matcher(mistake);
        while (option.find()) {
            names.add(option.group(1));
        }
        return names;
    }
}
