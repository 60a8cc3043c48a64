package org.evoloop.fleet;

import java.io.PrintWriter;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.fleet.stream.DeadLetters;
import org.evoloop.fleet.wire.Refusal;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Sends a fleet's dead letters again. */
@Command(
        name = "resend",
        description = {
            "Sends dead letters again, after their cause was removed: each once, in order. One that still cannot be processed"
                    + " comes back as a new dead letter."
        },
        mixinStandardHelpOptions = true,
        sortOptions = false)
final class ResendCommand implements Callable<Integer> {
    /** Those that can be processed once something else was changed. */
    private static final Set<String> MENDED_ELSEWHERE = words(Stream.of(
            Refusal.Reason.UNKNOWN_DEVICE,
            Refusal.Reason.UNKNOWN_MODEL,
            Refusal.Reason.UNUSABLE_MODEL,
            Refusal.Reason.UNUSABLE_STATE,
            Refusal.Reason.NEWER_SCHEMA,
            Refusal.Reason.DEFECT));

    private static final Set<String> ALL = words(Stream.of(Refusal.Reason.values()));

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ClusterOptions cluster;

    @Option(
            names = "--reason",
            paramLabel = "REASON",
            split = ",",
            description = "Only letters with these reasons (default: unknown-device, unknown-model, unusable-model,"
                    + " unusable-state, newer-schema, defect).")
    private @Nullable Set<String> reasons;

    @Option(names = "--list", description = "Only lists them: reason, topic, device and detail, separated by tabs.")
    private boolean list;

    private static Set<String> words(Stream<Refusal.Reason> reasons) {
        return reasons.map(each -> each.name().toLowerCase(Locale.ROOT).replace('_', '-'))
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    @Override
    public Integer call() {
        Set<String> wanted = reasons == null ? MENDED_ELSEWHERE : reasons;
        for (String reason : wanted) {
            if (!ALL.contains(reason)) {
                throw new IllegalArgumentException(
                        "--reason is '" + reason + "', allowed are " + String.join(", ", ALL));
            }
        }
        cluster.check();
        DeadLetters letters = new DeadLetters(cluster.cluster(), cluster.fleet());
        PrintWriter out = spec.commandLine().getOut();
        if (list) {
            letters.eachUnsent(
                    wanted,
                    (device, letter) -> out.println(String.join(
                            "\t",
                            letter.reason(),
                            letter.topic(),
                            device == null ? "" : oneLine(device),
                            oneLine(letter.detail()))));
            return 0;
        }
        DeadLetters.Counts counts = letters.sendAgain(wanted);
        counts.sent().forEach((reason, number) -> out.println(reason + ": " + number + " sent again"));
        if (counts.sent().isEmpty()) {
            out.println("there are no dead letters to send again");
        }
        if (counts.cut() > 0) {
            spec.commandLine()
                    .getErr()
                    .println("evoloop: " + counts.cut()
                            + " were too large to be kept whole, and must be sent again by who sent them first");
        }
        return 0;
    }

    /** A name or a detail may contain line breaks and tabs of whoever wrote the record. */
    private static String oneLine(String text) {
        return text.replaceAll("\\p{Cntrl}", " ");
    }
}
