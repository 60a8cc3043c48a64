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

/** What two pairs of models have in common if one can go on with the journal of the other. */
final class Fingerprint {
    private static final int DIGITS = 16;

    private Fingerprint() {}

    /** Of everything in both models that decides how a converter behaves, in hexadecimal digits. */
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
            throw new JournalException(
                    file + ", byte " + Preamble.BYTES + ", record 0: the journal is of other models: '"
                            + head.models().original().name() + "' and '"
                            + head.models().evolved().name() + "', fingerprint " + head.fingerprint()
                            + ", not '" + models.original().name() + "' and '"
                            + models.evolved().name() + "', fingerprint " + fingerprint
                            + "; start with the models that it was written with, or use another directory");
        }
    }

    /** All but its name, which may be that of the file it was read from: that may move. */
    private static void describe(StateMachine machine, StringBuilder text) {
        text.append(machine.initial()).append('\n');
        text.append(machine.spontaneous().stream().sorted().toList()).append('\n');
        for (State state : machine.states().stream().sorted().toList()) {
            text.append(state)
                    .append(machine.deferred(state).stream().sorted().toList())
                    .append('\n');
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
