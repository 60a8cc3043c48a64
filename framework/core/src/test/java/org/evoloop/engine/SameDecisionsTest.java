package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/**
 * What models without device states mean does not change: every decision on random pairs, in every pair of states, as a
 * digest, except what functions ask for. Change it only if the paper's algorithm is understood differently on purpose.
 */
class SameDecisionsTest {
    private static final String BEFORE = "0f88cd50ff72b703da55629fead83483431740335736750f8537030da05c89b7";
    private static final int PAIRS = 500;

    @Test
    void areThoseOfTheFirstVersion() throws Exception {
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        LongStream.rangeClosed(1, PAIRS)
                .forEach(seed -> digest.update(decisions(seed).getBytes(StandardCharsets.UTF_8)));

        assertThat(HexFormat.of().formatHex(digest.digest())).isEqualTo(BEFORE);
    }

    static String decisions(long seed) {
        DeviceEvents device =
                new DeviceEvents(Set.of(new Event("a"), new Event("b")), Set.of(new Event("x"), new Event("a")));
        DecisionTable table = DecisionTable.compile(RandomPair.models(seed), device);
        List<Object> all = new ArrayList<>(table.configurations());
        all.addAll(table.problems());
        all.addAll(table.hazards());
        for (State original : table.models().original().states()) {
            for (State evolved : table.models().evolved().states()) {
                decide(all, table, new Configuration(original, evolved));
            }
        }
        return all.toString();
    }

    private static void decide(List<Object> all, DecisionTable table, Configuration at) {
        for (Event event : table.models().evolved().events()) {
            all.add(table.decide(at, event, false));
            all.add(table.decide(at, event, true));
            all.add(table.react(at, event, table.ownStep(at.original(), event, guard -> false), true));
        }
        table.models().original().states().forEach(found -> all.add(table.find(at, found)));
        all.add(table.settle(at));
        all.add(table.standsTogether(at));
        all.add(table.isFollowed(at));
        all.add(table.expected(at));
        all.add(table.interference(at));
    }
}
