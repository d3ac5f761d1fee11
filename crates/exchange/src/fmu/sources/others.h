/* Functions of the standard for kinds of variables, clocks and modes that this unit has none of. */

#define NONE(function, arguments) \
    EXPORT fmi3Status FMI(function) arguments \
    { \
        return fmi3Error; \
    }
#define VALUES(type) \
    EXPORT fmi3Status FMI(fmi3Get##type)(fmi3Instance handle, const fmi3ValueReference of[], size_t count, fmi3##type values[], size_t length) \
    { \
        UNUSED(handle), UNUSED(of), UNUSED(values), UNUSED(length); \
        return count == 0 ? fmi3OK : fmi3Error; \
    } \
    EXPORT fmi3Status FMI(fmi3Set##type)(fmi3Instance handle, const fmi3ValueReference of[], size_t count, const fmi3##type values[], \
                                         size_t length) \
    { \
        UNUSED(handle), UNUSED(of), UNUSED(values), UNUSED(length); \
        return count == 0 ? fmi3OK : fmi3Error; \
    }
#if defined __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

VALUES(Float32)
VALUES(Int8)
VALUES(UInt8)
VALUES(Int16)
VALUES(UInt16)
VALUES(Int32)
VALUES(UInt32)
VALUES(Int64)
VALUES(UInt64)
VALUES(Boolean)
VALUES(String)
NONE(fmi3GetBinary, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, size_t sizes[], fmi3Binary values[], size_t length))
NONE(fmi3SetBinary, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const size_t sizes[], const fmi3Binary values[], size_t length))
NONE(fmi3GetClock, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, fmi3Clock values[]))
NONE(fmi3SetClock, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3Clock values[]))
NONE(fmi3GetNumberOfVariableDependencies, (fmi3Instance instance, fmi3ValueReference of, size_t *count))
NONE(fmi3GetVariableDependencies, (fmi3Instance instance, fmi3ValueReference of, size_t elements[], fmi3ValueReference by[], size_t elements_by[],
      fmi3DependencyKind kinds[], size_t count))
NONE(fmi3SerializedFMUStateSize, (fmi3Instance instance, fmi3FMUState state, size_t *size))
NONE(fmi3SerializeFMUState, (fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size))
NONE(fmi3DeserializeFMUState, (fmi3Instance instance, const fmi3Byte bytes[], size_t size, fmi3FMUState *state))
NONE(fmi3GetAdjointDerivative, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3ValueReference by[], size_t count_by, const fmi3Float64 seed[],
      size_t seeds, fmi3Float64 values[], size_t length))
NONE(fmi3EnterConfigurationMode, (fmi3Instance instance))
NONE(fmi3ExitConfigurationMode, (fmi3Instance instance))
NONE(fmi3GetIntervalDecimal, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, fmi3Float64 values[], fmi3IntervalQualifier qualifiers[]))
NONE(fmi3GetIntervalFraction, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, fmi3UInt64 values[], fmi3UInt64 per[], fmi3IntervalQualifier qualifiers[]))
NONE(fmi3GetShiftDecimal, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, fmi3Float64 values[]))
NONE(fmi3GetShiftFraction, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, fmi3UInt64 values[], fmi3UInt64 per[]))
NONE(fmi3SetIntervalDecimal, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3Float64 values[]))
NONE(fmi3SetIntervalFraction, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3UInt64 values[], const fmi3UInt64 per[]))
NONE(fmi3SetShiftDecimal, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3Float64 values[]))
NONE(fmi3SetShiftFraction, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3UInt64 values[], const fmi3UInt64 per[]))
NONE(fmi3GetOutputDerivatives, (fmi3Instance instance, const fmi3ValueReference of[], size_t count, const fmi3Int32 orders[], fmi3Float64 values[], size_t length))
NONE(fmi3ActivateModelPartition, (fmi3Instance instance, fmi3ValueReference of, fmi3Float64 time))
