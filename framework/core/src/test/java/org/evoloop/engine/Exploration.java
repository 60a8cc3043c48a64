package org.evoloop.engine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;

/** Explores every interleaving of a scene, shortest first, and equal situations once. */
final class Exploration {
    /** How a situation was reached. */
    private record Path(@Nullable Path before, String what) {
        @Override
        public String toString() {
            List<String> all = new ArrayList<>();
            for (Path path = this; path.before != null; path = path.before) {
                all.add(0, path.what);
            }
            return String.join("\n", all);
        }
    }

    private record Situation(Path path, Snapshot snapshot, World world, int depth) {}

    /**
     * The result.
     *
     * @param situations how many were reached
     * @param depth of the deepest
     * @param violation empty if every invariant holds, else what is violated, and the inputs that lead there
     */
    record Result(int situations, int depth, String violation) {}

    private final Scene scene;
    private final Wiring wiring;
    private final BiConsumer<Rules, Snapshot> visitor;
    private final Map<Object, Integer> parts = new HashMap<>();
    private final Set<List<Integer>> seen = new HashSet<>();
    private final Queue<Situation> frontier = new ArrayDeque<>();

    private Exploration(Scene scene, Wiring wiring, BiConsumer<Rules, Snapshot> visitor) {
        this.scene = scene;
        this.wiring = wiring;
        this.visitor = visitor;
    }

    /** Explores to the end, until an invariant is violated, or up to this many inputs. */
    static Result of(Scene scene, Wiring wiring, int depth) {
        return new Exploration(scene, wiring, (rules, snapshot) -> {}).run(depth);
    }

    /** @param visitor receives each situation of the core */
    static Result of(Scene scene, int depth, BiConsumer<Rules, Snapshot> visitor) {
        return new Exploration(scene, Wiring.REAL, visitor).run(depth);
    }

    private Result run(int depth) {
        Snapshot first = new Core(scene.rules(), output -> {}).snapshot();
        meet(new Situation(new Path(null, ""), first, new World(scene), 0));
        int deepest = 0;
        for (Situation at = frontier.poll(); at != null; at = frontier.poll()) {
            deepest = at.depth();
            if (deepest == depth) {
                continue;
            }
            long time = Math.max(at.depth() + 1, at.snapshot().nowNanos());
            List<Move> moves = Moves.of(at.snapshot(), at.world(), time);
            boolean idle = moves.stream().allMatch(move -> move.input() instanceof Input.Ready);
            Work work = at.snapshot().work();
            if (idle && work != null && work.stage() != Work.Stage.INTERRUPTED) {
                return new Result(seen.size(), deepest, "stuck: nothing can happen\n" + at.path());
            }
            for (Move move : moves) {
                String violation = go(at, move);
                if (!violation.isEmpty()) {
                    return new Result(seen.size(), deepest, violation);
                }
            }
        }
        return new Result(seen.size(), deepest, "");
    }

    private String go(Situation at, Move move) {
        Snapshot before = at.snapshot();
        World world = move.world();
        List<Output> said = List.of();
        Snapshot after = before;
        if (move.input() != null) {
            Wiring.Result result = wiring.apply(at.world().rules(), before, move.input());
            said = result.said();
            after = result.after();
            world.heard(move.input(), said, after);
        }
        Path path = new Path(at.path(), move.what());
        String violation = Invariants.check(before, move.input(), said, after, world);
        if (violation.isEmpty()) {
            meet(new Situation(path, after, world, at.depth() + 1));
            return "";
        }
        return violation + "\n" + path;
    }

    private void meet(Situation situation) {
        List<Object> likeness = Likeness.of(situation.snapshot(), situation.world());
        List<Integer> key = new ArrayList<>();
        for (Object part : likeness) {
            key.add(parts.computeIfAbsent(part, unknown -> parts.size()));
        }
        if (seen.add(key)) {
            visitor.accept(situation.world().rules(), situation.snapshot());
            frontier.add(situation);
        }
    }
}
