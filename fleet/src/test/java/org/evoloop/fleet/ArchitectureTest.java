package org.evoloop.fleet;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Which packages may use Kafka, and each other. */
@AnalyzeClasses(packages = "org.evoloop.fleet", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule aDeviceAndItsRecordsKnowNothingOfKafka = noClasses()
            .that()
            .resideInAnyPackage("..fleet.device..", "..fleet.wire..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.apache.kafka..", "kafka..", "..fleet.stream..");

    @ArchTest
    static final ArchRule aDeviceKnowsNothingOfHowItIsWritten = noClasses()
            .that()
            .resideInAPackage("..fleet.device..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(
                    "..fleet.wire..", "tools.jackson..", "org.evoloop.converter..", "java.util.concurrent..");

    @ArchTest
    static final ArchRule theTopologyKnowsNeitherDemoNorBroker = noClasses()
            .that()
            .resideInAPackage("..fleet.stream..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("..fleet.demo..", "..fleet.broker..", "picocli..");
}
