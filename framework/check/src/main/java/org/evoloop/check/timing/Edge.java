package org.evoloop.check.timing;

import java.util.List;
import java.util.stream.IntStream;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.timing.Situation.Branch;
import org.evoloop.check.timing.Situation.Sight;
import org.evoloop.evolution.ModelPair;
import org.jspecify.annotations.Nullable;

/** Something that happens and one of its possible continuations, with what formulas see of it. */
final class Edge {
    final int number;

    /** Null for the opening. */
    final @Nullable Stimulus stimulus;

    final Branch branch;

    /** For each monitor what it sees, moment by moment: bit 0 the subject, bit 1 the other. */
    final int[][] seen;

    /** For each event that is awaited, moment by moment, whether the time lasts in which it comes. */
    final boolean[][] lasts;

    Edge(
            int number,
            @Nullable Stimulus stimulus,
            Branch branch,
            List<TimeForm> forms,
            List<Assumption.Comes> comings,
            ModelPair pair) {
        this.number = number;
        this.stimulus = stimulus;
        this.branch = branch;
        this.seen = new int[forms.size()][];
        for (int index = 0; index < seen.length; index++) {
            TimeForm form = forms.get(index);
            seen[index] = branch.sights().stream()
                    .flatMapToInt(sight -> sight.event() == null
                            ? IntStream.of(code(form, new Moment(sight.at(), null), pair))
                            : IntStream.of(
                                    code(form, new Moment(sight.at(), sight.event()), pair),
                                    code(form, new Moment(sight.at(), null), pair)))
                    .toArray();
        }
        this.lasts = new boolean[comings.size()][];
        for (int index = 0; index < lasts.length; index++) {
            Formula.Atom during = comings.get(index).during();
            lasts[index] = new boolean[branch.sights().size()];
            for (int sight = 0; sight < lasts[index].length; sight++) {
                Sight at = branch.sights().get(sight);
                lasts[index][sight] = new Moment(at.at(), null).shows(during, pair);
            }
        }
    }

    private static int code(TimeForm form, Moment moment, ModelPair pair) {
        return (form.subject().isSeenIn(moment, pair) ? 1 : 0) | (form.other().isSeenIn(moment, pair) ? 2 : 0);
    }
}
