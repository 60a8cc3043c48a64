package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Violations that Spin found with a mechanism removed from the specification: the core follows the same path without
 * that mechanism, and a different one with it.
 */
class TrailsTest {
    private static final Path TRAILS = Path.of(System.getProperty("evoloop.root"), "prism", "results", "proof");

    static Stream<Removal> ofTheSpecification() {
        return Stream.<Removal[]>of(Mutation.values(), DeviceStateMutation.values())
                .flatMap(Stream::of)
                .filter(mutation -> Files.exists(trail(mutation)));
    }

    private static Path trail(Removal mutation) {
        return TRAILS.resolve(mutation.name().toLowerCase(Locale.ROOT).replace('_', '-') + ".txt");
    }

    @ParameterizedTest
    @MethodSource("ofTheSpecification")
    void theCoreGoesTheSameWayWithoutTheMechanismOnly(Removal mutation) throws IOException {
        List<String> lines = Files.readAllLines(trail(mutation));

        assertThat(Trail.follow(mutation.scene(), mutation.wiring(), lines))
                .as("without the mechanism")
                .isEmpty();
        assertThat(Trail.follow(mutation.scene(), Wiring.REAL, lines))
                .as("with it")
                .isNotEmpty();
    }
}
