package org.evoloop.benchmarks.profile;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;

/** A profile as text: the most important methods, threads and allocations. */
public final class ProfileText {
    private static final int LINES = 12;

    private ProfileText() {}

    /** The top few of each, with their share in percent. */
    public static String of(Profile profile) {
        Map<String, Long> threads = new HashMap<>();
        Map<String, Long> self = new HashMap<>();
        Map<String, Long> inclusive = new HashMap<>();
        profile.samples().forEach((stack, count) -> {
            threads.merge(stack.thread(), count, Long::sum);
            int last = stack.methods().size() - 1;
            self.merge(last < 0 ? "?" : stack.methods().get(last), count, Long::sum);
            // A recursive method counts only once per stack.
            new HashSet<>(stack.methods()).forEach(method -> inclusive.merge(method, count, Long::sum));
        });
        Map<String, Long> allocated = new HashMap<>();
        profile.allocations()
                .forEach((allocation, bytes) ->
                        allocated.merge(allocation.type() + " in " + allocation.method(), bytes, Long::sum));
        long samples = profile.sampleCount();
        long bytes = profile.allocations().values().stream()
                .mapToLong(Long::longValue)
                .sum();
        Profile.Load load = profile.load();
        return String.format(
                        Locale.ROOT,
                        "%d samples; %.0f %% of all processors taken, and %.0f %% by the kernel for it%n",
                        samples,
                        100 * load.user(),
                        100 * load.kernel())
                + section("threads", threads, samples)
                + section("methods that ran", self, samples)
                + section("methods that ran or had called what ran", inclusive, samples)
                + (bytes == 0 ? "  nothing was allocated\n" : section("allocated bytes, estimated", allocated, bytes));
    }

    private static String section(String title, Map<String, Long> counts, long all) {
        StringBuilder text = new StringBuilder("  " + title + "\n");
        counts.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue(Comparator.reverseOrder())
                        .thenComparing(Map.Entry.comparingByKey()))
                .limit(LINES)
                .forEach(entry -> text.append(
                        String.format(Locale.ROOT, "%8.1f %%  %s%n", 100.0 * entry.getValue() / all, entry.getKey())));
        return text.toString();
    }
}
