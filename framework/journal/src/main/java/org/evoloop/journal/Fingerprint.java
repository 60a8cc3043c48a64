package org.evoloop.journal;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** A fingerprint of two models: pairs with the same one can continue each other's journal. */
final class Fingerprint {
    private static final int DIGITS = 16;

    private Fingerprint() {}

    /** The fingerprint of everything in both models that determines a converter's behaviour, in hexadecimal digits. */
    static String of(ModelPair models) {
        StringBuilder text = new StringBuilder();
        describe(models.original(), text);
        describe(models.evolved(), text);
        try {
            byte[] digest =
                    MessageDigest.getInstance("SHA-256").digest(text.toString().getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest).substring(0, DIGITS);
        } catch (NoSuchAlgorithmException impossible) {
            throw new AssertionError("every Java has SHA-256", impossible);
        }
    }

    /**
     * @throws JournalException if the journal's newest segment is of other models than {@code models}, which have this
     * fingerprint
     */
    static void requireSame(Path file, Head head, String fingerprint, ModelPair models) {
        if (!head.fingerprint().equals(fingerprint)) {
            boolean changed = head.models()
                            .original()
                            .name()
                            .equals(models.original().name())
                    && head.models().evolved().name().equals(models.evolved().name());
            throw new JournalException(
                    file + ", byte " + Preamble.BYTES + ", record 0: the journal is of other models: '"
                            + head.models().original().name() + "' and '"
                            + head.models().evolved().name() + "', fingerprint " + head.fingerprint()
                            + ", not '" + models.original().name() + "' and '"
                            + models.evolved().name() + "', fingerprint " + fingerprint
                            + (changed
                                    ? "; a model has changed since: start with it as it was, or use another directory; while a"
                                            + " converter runs, evolve and reload change models"
                                    : "; start with the models that it was written with, or use another directory"));
        }
    }

    /** Everything except its name, which may be that of the file that it was read from: the file may be moved. */
    private static void describe(StateMachine machine, StringBuilder text) {
        text.append(machine.initial()).append('\n');
        text.append(machine.spontaneous().stream().sorted().toList()).append('\n');
        text.append(machine.urgent().stream().sorted().toList()).append('\n');
        for (State state : machine.states().stream().sorted().toList()) {
            text.append(state).append(machine.deferred(state).stream().sorted().toList());
            String device = machine.deviceState(state);
            if (device != null) {
                text.append(" device ").append(device);
            }
            if (!machine.sends(state).isEmpty()) {
                text.append(" sends ")
                        .append(machine.sends(state).stream().sorted().toList());
            }
            text.append('\n');
        }
        for (Transition transition : machine.transitions()) {
            text.append(transition)
                    .append(transition.effects())
                    .append(transition.internal())
                    .append(transition.keeps().stream().sorted().toList())
                    .append('\n');
        }
    }
}
