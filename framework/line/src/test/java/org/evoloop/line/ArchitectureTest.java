package org.evoloop.line;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.net.Socket;
import java.time.Instant;

/** How the protocol may depend on its transports and on time. */
@AnalyzeClasses(packages = "org.evoloop.line", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule socketsAreKnownInOnePlace = noClasses()
            .that()
            .haveNameNotMatching(".*\\.TcpTransport(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .belongToAnyOf(Socket.class);

    @ArchTest
    static final ArchRule timeIsInjected = noClasses()
            .should()
            .callMethod(System.class, "nanoTime")
            .orShould()
            .callMethod(Instant.class, "now")
            .orShould()
            .callMethod(Thread.class, "sleep", long.class);
}
