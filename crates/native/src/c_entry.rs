//! Machine code of an entry that C calls without a context: it adds a fixed context and passes its arguments on.

use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::ir::{self, AbiParam, Function, InstBuilder, Signature, UserFuncName, types};
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};

/// The code of a function `(time, state, values)` that calls the function at `target` with `(context, time, state,
/// values)`; `None` where the code generator fails.
pub fn instructions(context: usize, target: usize, isa: &OwnedTargetIsa) -> Option<Vec<u8>> {
    let (pointer, convention) = (isa.pointer_type(), isa.default_call_conv());
    let signature = |takes: &[ir::Type]| {
        let mut signature = Signature::new(convention);
        signature.params.extend(takes.iter().map(|each| AbiParam::new(*each)));
        signature
    };
    let own = signature(&[types::F64, pointer, pointer]);
    let mut unit = Context::for_function(Function::with_name_signature(UserFuncName::default(), own));
    let mut builder = FunctionBuilderContext::new();
    let mut code = FunctionBuilder::new(&mut unit.func, &mut builder);
    let called = code.import_signature(signature(&[pointer, types::F64, pointer, pointer]));
    let block = code.create_block();
    code.append_block_params_for_function_params(block);
    code.switch_to_block(block);
    code.seal_block(block);
    let &[time, state, values] = code.block_params(block) else { return None };
    let [context, target] = [context, target].map(|address| i64::try_from(address).ok());
    let context = code.ins().iconst(pointer, context?);
    let target = code.ins().iconst(pointer, target?);
    code.ins().call_indirect(called, target, &[context, time, state, values]);
    code.ins().return_(&[]);
    code.finalize();
    let compiled = unit.compile(&**isa, &mut ControlPlane::default()).ok()?;
    compiled.buffer.relocs().is_empty().then(|| compiled.code_buffer().to_vec())
}
