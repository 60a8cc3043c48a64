package org.evoloop.engine;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Random;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;

/** A random path through exploration's world, in the words of a {@link Trail}. */
final class Story {
    private final StringBuilder lines = new StringBuilder("anew\n");
    private final Random random;
    private Snapshot now;
    private World world;

    private Story(Scene scene, long seed) {
        random = new Random(seed);
        now = new Core(scene.rules(), output -> {}).snapshot();
        world = new World(scene);
        lines.append(Trail.state(now)).append('\n');
    }

    static String of(Scene scene, long seed, int most) {
        Story story = new Story(scene, seed);
        for (int time = 1; time <= most && story.continues(time); time++) {}
        return story.lines.toString();
    }

    private boolean continues(long time) {
        List<Move> moves = Moves.of(now, world, time).stream()
                .sorted(Comparator.comparing(Move::what))
                .toList();
        if (moves.isEmpty()) {
            return false;
        }
        Move move = moves.get(random.nextInt(moves.size()));
        Input input = move.input();
        if (input != null) {
            lines.append(words(input)).append('\n');
            Wiring.Result result = Wiring.REAL.apply(world.rules(), now, input);
            now = result.after();
            move.world().heard(input, result.said(), now);
            lines.append(Trail.state(now)).append('\n');
        }
        world = move.world();
        return true;
    }

    private String words(Input input) {
        if (input instanceof Input.Observed observed) {
            return words(observed.occurrence());
        } else if (input instanceof Input.Planned planned) {
            Decision decision = planned.decision();
            return "planned " + decision.deviceStart() + " " + decision.before().evolved();
        } else if (input instanceof Input.Sent sent) {
            return "sent " + sent.number() + (sent.inOrder() ? " in-order" : " -");
        } else if (input instanceof Input.Located located) {
            return "located " + (located.state() == null ? "-" : Objects.requireNonNull(located.state()));
        } else if (input instanceof Input.GivenUp) {
            return "given-up";
        } else if (input instanceof Input.TimerDue due) {
            return due.visit() == now.visit().number() ? "timer" : "late-timer";
        }
        return input.getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }

    private String words(Occurrence occurrence) {
        String visit = occurrence.visit() == now.visit().number() ? " present" : " former";
        if (occurrence instanceof Occurrence.Found found) {
            return "found " + found.state() + (found.observedNanos() < now.lastStepNanos() ? " late" : " -");
        } else if (occurrence instanceof Occurrence.Asked asked) {
            return "ask " + asked.event() + visit;
        }
        Occurrence.Heard heard = (Occurrence.Heard) occurrence;
        if (heard.source() == Source.CONTROLLER) {
            return "press " + heard.event();
        }
        return heard.source() == Source.DEVICE
                ? "own " + heard.event() + (heard.deviceActed() ? " acted" : " -")
                : "raise " + heard.event() + visit;
    }
}
